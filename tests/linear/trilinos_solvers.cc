// SPDX-License-Identifier: LGPL-2.1-or-later
// The solvers that are not our own on the matrix of an elastic square, fixed at one edge: the solution is
// that of a dense factorisation, and so is the compliance of a few rows; a matrix without positive diagonal
// is refused. Multigrid that knows the rotations needs few more iterations when the square has sixteen times
// as many unknowns. In other units, by powers of two, the solution has the same bits. Many bodies at once on
// four threads are solved to the bits of one after the other: Trilinos and MPI are not made for several
// threads.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mpi_session.h>
#include <softgrain/base/parallel.h>

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

/// Whether a force of @p force gives the same bits where the matrix is @p stiffness times as large: with
/// factors that are powers of two all but roots and thresholds is exact.
bool same_in_units(const double stiffness, const double force)
{
  LinearSolverSettings settings;
  settings.type = "cg_amg";
  const auto solved = [&](const double of_matrix, const double of_right)
  {
    SystemMatrix matrix = square(12, of_matrix);
    const auto solver = create_linear_solver(settings, matrix, 2, false);
    solver->factorize(matrix);
    Eigen::VectorXd x;
    solver->solve(of_right * Eigen::VectorXd::LinSpaced(matrix.lower().rows(), -1., 2.), x);
    return x;
  };
  return solved(1., 1.) == Eigen::VectorXd(stiffness / force * solved(stiffness, force));
}

/// Whether a solver gives the same bits for bodies that are solved at once as for one alone.
bool same_at_once(const std::string &name)
{
  LinearSolverSettings settings;
  settings.type = name;
  std::vector<SystemMatrix> matrix(16, square(8));
  std::vector<std::unique_ptr<LinearSolver>> solver;
  for (SystemMatrix &one : matrix)
    solver.push_back(create_linear_solver(settings, one, 2, false));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(matrix[0].lower().rows(), -1., 2.);
  Eigen::VectorXd alone;
  solver[0]->factorize(matrix[0]);
  solver[0]->solve(b, alone);
  bool same = true;
  for (unsigned int round = 0; round < 10; ++round)
  {
    std::vector<Eigen::VectorXd> x(matrix.size());
    const auto work = [&](const std::size_t begin, const std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        solver[i]->factorize(matrix[i]);
        for (unsigned int n = 0; n < 20; ++n)
          solver[i]->solve(b, x[i]);
      }
    };
    parallel_for(matrix.size(), 1, work);
    for (const Eigen::VectorXd &one : x)
      same = same && one == alone;
  }
  return same;
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
  bool same = true;
  for (const int power : {-31, -8, -5, 1, 6, 17})
    same =
        same && same_in_units(std::exp2(power), 1.) && same_in_units(std::exp2(power), std::exp2(-3 * power));
  std::cout << "cg_amg, in other units: the same bits " << yes(same) << '\n';
  set_n_threads(4);
  std::cout << "cg_amg, sixteen bodies at once: the same bits " << yes(same_at_once("cg_amg")) << '\n';
}
