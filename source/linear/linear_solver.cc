// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/banded_solver.h>
#include <softgrain/linear/cholesky_solver.h>
#include <softgrain/linear/linear_solver.h>
#include <softgrain/linear/linear_solver_kind.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::LinearSolverKind)

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
  return Registry<LinearSolverKind>::instance().create(type)->create(settings, dim);
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
