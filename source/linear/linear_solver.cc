// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/banded_solver.h>
#include <softgrain/linear/cholesky_solver.h>
#include <softgrain/linear/linear_solver.h>
#include <softgrain/linear/linear_solver_kind.h>

#include <string>
#include <vector>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::LinearSolverKind)

namespace softgrain
{
namespace
{
/// Multigrid for bodies that nothing touches, where this program has it.
const char multigrid[] = "cg_amg";
} // namespace

void check_linear_solver(const std::string &type)
{
  if (type == "automatic")
    return;
  const Registry<LinearSolverKind> &kinds = Registry<LinearSolverKind>::instance();
  const std::string missing = kinds.create(type)->missing();
  if (missing.empty())
    return;
  std::vector<std::string> allowed = {"automatic"};
  for (const std::string &name : kinds.names())
    if (kinds.create(name)->missing().empty())
      allowed.push_back(name);
  throw InputError("'Linear solver/Type' = '" + type + "' needs " + missing +
                   ", which is not there in the deal.II that this program was built with; allowed are " +
                   join(allowed));
}

std::unique_ptr<LinearSolver> create_linear_solver(const LinearSolverSettings &settings,
                                                   const SystemMatrix &matrix,
                                                   const unsigned int dim,
                                                   const bool condensed)
{
  const Registry<LinearSolverKind> &kinds = Registry<LinearSolverKind>::instance();
  std::string type = settings.type;
  if (type == "automatic")
  {
    // The band costs n b^2 operations at some ten times the rate of a sparse factorisation.
    if (!condensed && matrix.lower().rows() > static_cast<int>(settings.automatic_dofs) &&
        kinds.create(multigrid)->missing().empty())
      type = multigrid;
    else
      type = BandedSolver::bandwidth(matrix) <= settings.automatic_band ? "banded_cholesky" : "cholesky";
  }
  return kinds.create(type)->create(settings, dim);
}

namespace
{
template <class Solver>
class Direct final : public LinearSolverKind
{
public:
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &, unsigned int) const override
  {
    return std::make_unique<Solver>();
  }
};

[[maybe_unused]] const bool registered[] = {
    Registry<LinearSolverKind>::instance().add("banded_cholesky",
                                               "dense kernels on the band of a compact body",
                                               [] { return std::make_unique<Direct<BandedSolver>>(); }),
    Registry<LinearSolverKind>::instance().add(
        "cholesky", "sparse (Eigen)", [] { return std::make_unique<Direct<CholeskySolver>>(); })};
} // namespace
} // namespace softgrain
