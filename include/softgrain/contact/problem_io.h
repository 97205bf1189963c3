// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_problem_io_h
#define softgrain_contact_problem_io_h

#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/problem.h>

#include <string>
#include <variant>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief A contact problem as it was handed to the solver, enough to solve it again to the last bit.
 *
 * File layout (HDF5; impulses in N s per metre, velocities in m/s, 1/mass in m/kg in the plane):
 * - attributes of `/`: `format` = "softgrain contact problem", `version` = 1, `description`, `operator`
 * ("blocks" or "mass"), `n_components`, `n_contacts`, and the settings `algorithm`, `tolerance`,
 * `max_sweeps`, `relaxation`, `check_interval`, `sweeps_before_newton`, `max_newton_components`,
 * `max_newton_iterations`
 * - `/free_velocity`, `/impulses` (the warm start): n_contacts * n_components; `/friction`: n_contacts, or
 * empty; `/cohesion`: n_contacts, only where contacts are held together
 * - blocks: `/block_size` (rows of each block), `/block_components` (the rows' components, block after
 * block),
 *   `/block_values` (the blocks one after the other, each row by row): W = Σ_b E_b W_b E_bᵀ
 * - mass: `/row_start`, `/dofs`, `/weights` (compressed rows of H), `/inverse_mass`: W = H M⁻¹ Hᵀ
 *
 * The operator is kept as it was, not assembled, so that sums run in the same order when the file is
 * replayed.
 */
struct SavedProblem
{
  std::string description;
  Problem problem;
  SolverSettings settings;
  std::variant<BlockDelassus, MassDelassus> delassus;
  /// Warm start, n_contacts * n_components (N s per metre).
  std::vector<double> impulses;
};

/// Writes @p saved to @p path: whole or not at all (to path + ".tmp", then renamed). @throw ComputationError.
void save_problem(const std::string &path, const SavedProblem &saved);

/// Writes a problem from the arguments of solve(); a DiagonalDelassus is stored as one block per contact.
void save_problem(const std::string &path,
                  const BlockDelassus &delassus,
                  const Problem &problem,
                  const SolverSettings &settings,
                  const std::vector<double> &impulses,
                  const std::string &description);
void save_problem(const std::string &path,
                  const MassDelassus &delassus,
                  const Problem &problem,
                  const SolverSettings &settings,
                  const std::vector<double> &impulses,
                  const std::string &description);
void save_problem(const std::string &path,
                  const DiagonalDelassus &delassus,
                  const Problem &problem,
                  const SolverSettings &settings,
                  const std::vector<double> &impulses,
                  const std::string &description);

/// Reads what save_problem() wrote. @throw InputError when the file is missing, damaged or of another kind.
SavedProblem load_problem(const std::string &path);

/**
 * @brief Reads a Siconos FrictionContactProblem (text; local form, u = W r + q, matrix storage 0 dense, 1
 * sparse blocks or 2 sparse), dimension 2 or 3. The warm start is zero.
 *
 * Entries that differ from their mirror image by up to 1e-5 of the largest are set to the mean of both:
 * sparse files have six digits.
 * @throw InputError when the file is missing, not of this form, or less symmetric.
 */
SavedProblem load_siconos_problem(const std::string &path);

/// Solves @p saved with its own settings and warm start, as solve() did when it was saved.
SolverReport replay(SavedProblem &saved, std::vector<double> &impulses, std::vector<double> &velocities);

/// Solves the problem of the file @p path again.
SolverReport replay(const std::string &path, std::vector<double> &impulses, std::vector<double> &velocities);
} // namespace softgrain::contact

#endif
