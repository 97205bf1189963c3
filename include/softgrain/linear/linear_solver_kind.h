// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_linear_solver_kind_h
#define softgrain_linear_linear_solver_kind_h

#include <softgrain/base/registry.h>
#include <softgrain/linear/linear_solver.h>

#include <memory>
#include <string>

namespace softgrain
{
/**
 * @brief A way to solve linear systems: `Linear solver/Type` names a member of this family, or `automatic`,
 * which chooses one for every body (create_linear_solver()).
 */
class LinearSolverKind
{
public:
  virtual ~LinearSolverKind() = default;

  /// What this program lacks for such a solver, such as "Trilinos"; nothing when it can be created.
  virtual std::string missing() const { return ""; }

  /// A solver for one body. @param dim number of rigid translations, for the near null space of AMG
  virtual std::unique_ptr<LinearSolver> create(const LinearSolverSettings &settings,
                                               unsigned int dim) const = 0;
};

/// @throw InputError when @p type, a value of `Linear solver/Type`, needs what this program was built without
void check_linear_solver(const std::string &type);
} // namespace softgrain

template <>
softgrain::Registry<softgrain::LinearSolverKind> &
softgrain::Registry<softgrain::LinearSolverKind>::instance();

#endif
