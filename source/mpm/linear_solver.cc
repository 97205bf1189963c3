// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/cholesky_solver.h>
#include <softgrain/mpm/linear_solver.h>

namespace softgrain::mpm
{
std::unique_ptr<LinearSolver>
create_linear_solver(const LinearSolverSettings &, const unsigned int, const unsigned int)
{
  return std::make_unique<CholeskySolver>();
}
} // namespace softgrain::mpm
