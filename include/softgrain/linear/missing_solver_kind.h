// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_missing_solver_kind_h
#define softgrain_linear_missing_solver_kind_h

#include <softgrain/linear/linear_solver_kind.h>

#include <string>

namespace softgrain
{
/**
 * @brief Stands where a solver would be, had its library been there when the program was built: the name is
 * known, and whoever asks for it is told why it cannot be had.
 */
class MissingSolverKind final : public LinearSolverKind
{
public:
  /// @param library what is not there
  explicit MissingSolverKind(std::string library);

  std::string missing() const override { return library; }

  /// @throw InputError always
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &settings, unsigned int dim) const override;

  /// Registers such a kind. @return whether the name was free
  static bool add(const std::string &name, const std::string &library);

private:
  const std::string library;
};
} // namespace softgrain

#endif
