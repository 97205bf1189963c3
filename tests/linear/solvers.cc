// SPDX-License-Identifier: LGPL-2.1-or-later
// Our own linear solvers on the matrix of an elastic square, fixed at one edge: the solution is that of a
// dense factorisation, and so is the compliance of a few rows; all eigenvalues of a matrix without positive
// diagonal are counted as negative. A solver that the program was built without is known by name: its
// description says what is missing, who asks for it is told, too, and `automatic` does not choose it.
#include <softgrain/base/exceptions.h>
#include <softgrain/linear/missing_solver_kind.h>

#include "linear/solver_check.h"

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
} // namespace

int main()
{
  for (const std::string name : {"banded_cholesky", "cholesky"})
    check(name);

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
