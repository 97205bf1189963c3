// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/linear/banded_solver.h>
#include <softgrain/linear/cholesky_solver.h>
#include <softgrain/linear/linear_solver.h>
#include <softgrain/linear/trilinos_solver.h>

namespace softgrain
{
std::unique_ptr<LinearSolver> create_linear_solver(const LinearSolverSettings &settings,
                                                   const SystemMatrix &matrix,
                                                   const unsigned int dim,
                                                   const bool condensed)
{
  std::string type = settings.type;
  if (type == "automatic")
  {
    // The band costs n b^2 operations at some ten times the rate of a sparse factorisation.
    if (!condensed && matrix.lower().rows() > static_cast<int>(settings.automatic_dofs))
      type = "cg_amg";
    else
      type = BandedSolver::bandwidth(matrix) <= settings.automatic_band ? "banded_cholesky" : "cholesky";
  }
  if (type == "banded_cholesky")
    return std::make_unique<BandedSolver>();
  if (type == "cholesky")
    return std::make_unique<CholeskySolver>();
  return create_trilinos_solver(type, settings, dim);
}
} // namespace softgrain
