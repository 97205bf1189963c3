// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/linear/missing_solver_kind.h>

#include <utility>

namespace softgrain
{
MissingSolverKind::MissingSolverKind(std::string library) : library(std::move(library)) {}

std::unique_ptr<LinearSolver> MissingSolverKind::create(const LinearSolverSettings &settings,
                                                        const unsigned int) const
{
  throw InputError("the linear solver '" + settings.type + "' needs " + library +
                   ", which is not there in the deal.II that this program was built with");
}

bool MissingSolverKind::add(const std::string &name, const std::string &library)
{
  return Registry<LinearSolverKind>::instance().add(
      name, "not in this program, which was built with a deal.II without " + library,
      [library] { return std::make_unique<MissingSolverKind>(library); });
}
} // namespace softgrain
