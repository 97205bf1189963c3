// SPDX-License-Identifier: LGPL-2.1-or-later
// The solvers that are not our own on the matrix of an elastic square, fixed at one edge: the solution is
// that of a dense factorisation, and so is the compliance of a few rows; a matrix without positive diagonal
// is refused. Multigrid that knows the rotations needs few more iterations when the square has sixteen times
// as many unknowns.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mpi_session.h>

#include "linear/solver_check.h"

using namespace softgrain;

namespace
{
/// Whether multigrid solves the square in so many iterations.
bool solves(const unsigned int n, const unsigned int iterations, const bool rotations)
{
  LinearSolverSettings settings;
  settings.type = "cg_amg";
  settings.max_iterations = iterations;
  SystemMatrix matrix = square(n);
  if (!rotations)
    matrix.set_places({});
  const auto solver = create_linear_solver(settings, matrix, 2, false);
  solver->factorize(matrix);
  Eigen::VectorXd x;
  try
  {
    solver->solve(Eigen::VectorXd::LinSpaced(matrix.lower().rows(), -1., 2.), x);
  }
  catch (const ComputationError &)
  {
    return false;
  }
  return true;
}
} // namespace

int main(int, char **argv)
{
  const MPISession mpi(argv);
  for (const std::string &name : Registry<LinearSolverKind>::instance().names())
    if (name.find("cholesky") == std::string::npos)
      check(name);
  std::cout << "multigrid: 3362 unknowns in 14 iterations " << yes(solves(40, 14, true))
            << ", 51842 unknowns in 18 iterations " << yes(solves(160, 18, true)) << ", without rotations "
            << yes(solves(160, 18, false)) << '\n';
}
