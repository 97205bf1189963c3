// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_solver_h
#define softgrain_contact_disk_solver_h

#include <softgrain/contact/disk_exchanges.h>
#include <softgrain/contact/disk_system.h>

#include <cstddef>
#include <string>

namespace softgrain
{
class Exchange;
}

namespace softgrain::contact
{
/// Contacts below which other threads or processes would cost more than they do.
constexpr std::size_t contacts_to_share = 4000;

/// Ways to solve the contacts between disks, or balls.
enum class DiskAlgorithm
{
  gauss_seidel, ///< plain sweeps, with relaxation
  accelerated   ///< sweeps with momentum and restart; falls back to plain ones when the residual grows
};

/// What solve_disks() may be told; a solution has to pass all the tolerances.
struct DiskSolverSettings
{
  DiskAlgorithm algorithm = DiskAlgorithm::accelerated;
  double tolerance = 1e-3;      ///< natural-map residual over the approach speed
  double wall_tolerance = 3e-2; ///< estimated error of the forces on walls over the largest of them
  double wall_floor = 0.;       ///< the largest counts as no less than this [N s/m]
  /// Worst approach speed that contacts may be left with [m/s]; 0: no matter.
  double penetration_tolerance = 0.;
  unsigned int max_sweeps = 10000;
  double relaxation = 1.; ///< in (0, 2); for plain sweeps
  unsigned int check_interval = 5;
};

/// What solve_disks() did.
struct DiskSolverReport
{
  unsigned int sweeps = 0;
  double residual = 0;    ///< of the solution returned
  double wall_change = 0; ///< estimated relative error of the wall forces
  double approach = 0;    ///< worst approach speed left in a contact [m/s]
  bool converged = false;
  unsigned int restarts = 0; ///< of the momentum
  bool fell_back = false;    ///< the accelerated solver gave up and plain sweeps finished
};

/**
 * @brief Solves the contacts: velocities of @p bodies go from free ones to those after contact.
 *
 * @p contacts brings the impulses to start from and takes those found. All threads work; the answer does not
 * depend on their number. By @p exchange all who bring the same share the sweeps unless there are few
 * contacts; the answer is the same and is known to all. With @p exchanges each of them brings its own
 * contacts and bodies alone, and is told the answer of these.
 * @throw ComputationError when something is not finite.
 */
DiskSolverReport solve_disks(DiskBodies &bodies,
                             DiskContacts &contacts,
                             const DiskSolverSettings &settings,
                             const Exchange *exchange = nullptr,
                             const DiskExchanges *exchanges = nullptr);

/// Solves the contacts between balls in space, here alone.
DiskSolverReport solve_balls(BallBodies &bodies, BallContacts &contacts, const DiskSolverSettings &settings);
} // namespace softgrain::contact

#endif
