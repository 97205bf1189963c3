// SPDX-License-Identifier: LGPL-2.1-or-later
// Our own linear solvers on the matrix of an elastic square, fixed at one edge: the solution is that of a
// dense factorisation, and so is the compliance of a few rows; all eigenvalues of a matrix without positive
// diagonal are counted as negative. A solver that the program was built without is known by name: its
// description says what is missing, who asks for it is told, too, and `automatic` does not choose it. Of a
// solver that cannot count negative eigenvalues CountingSolver makes one that does, for every matrix.
#include <softgrain/base/exceptions.h>
#include <softgrain/linear/counting_solver.h>
#include <softgrain/linear/missing_solver_kind.h>

#include "linear/solver_check.h"

#include <Eigen/Eigenvalues>

using namespace softgrain;

namespace
{
void print(const std::function<void()> &ask)
{
  try
  {
    ask();
    std::cout << "no refusal\n";
  }
  catch (const InputError &error)
  {
    const std::string what = error.what();
    std::cout << what.substr(0, what.find("; allowed")) << '\n'; // those differ from build to build
  }
}

/// Cannot tell how many negative eigenvalues a matrix has.
class Silent final : public LinearSolver
{
public:
  bool factorize(SystemMatrix &matrix) override
  {
    matrix.clear_pattern_flag();
    return true;
  }
  std::optional<unsigned int> n_negative() const override { return std::nullopt; }
  void solve(const Eigen::VectorXd &, Eigen::VectorXd &) override {}
  void condense(const Rows &, Eigen::MatrixXd &) override {}
};

unsigned int exactly(const SystemMatrix &matrix)
{
  const Eigen::MatrixXd dense = Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>();
  return (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues().array() < 0.).count();
}

void count()
{
  CountingSolver solver(std::make_unique<Silent>());
  for (const unsigned int n : {12, 7})
  {
    SystemMatrix matrix = square(n);
    for (const double shift : {0., -0.02, -0.2, -1000.})
    {
      matrix.add_mass<2>(Eigen::VectorXd::Ones((n + 1) * (n + 1)), shift);
      const bool taken = solver.factorize(matrix);
      std::cout << "negative " << exactly(matrix) << ", counted "
                << yes(taken && solver.n_negative() == exactly(matrix)) << '\n';
    }
  }
}
} // namespace

int main()
{
  for (const std::string name : {"banded_cholesky", "cholesky"})
    check(name);
  count();

  const std::string name = "cg_elsewhere";
  MissingSolverKind::add(name, "Elsewhere");
  std::cout << Registry<LinearSolverKind>::instance().description(name) << '\n';
  print([&] { check_linear_solver(name); });
  print([&] { check_linear_solver("cholesky"); });
  LinearSolverSettings settings;
  settings.type = name;
  const SystemMatrix matrix = square(2);
  print([&] { create_linear_solver(settings, matrix, 2, false); });
}
