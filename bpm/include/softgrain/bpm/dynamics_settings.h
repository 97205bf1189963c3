// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_dynamics_settings_h
#define softgrain_bpm_dynamics_settings_h

#include <softgrain/contact/disk_solver.h>
#include <softgrain/scene/contact_pairs.h>

#include <memory>

namespace softgrain::bpm
{
/// What the motion of primaries may be told. Lengths are in mean diameters of the primaries.
struct DynamicsSettings
{
  ContactPairs pairs;                  ///< friction and adhesion of primaries of different bodies and walls
  double rolling_resistance = 0;       ///< mu_r of @cite nguyen2016, eq. (2.12): different bodies, walls
  double inner_rolling_resistance = 0; ///< mu_r between primaries of one body
  double restitution = 0;              ///< normal, of every contact
  double gap_correction = 1;           ///< share of an overlap that is pushed out in a step
  double contact_range = 0.02;         ///< pairs nearer than this are contacts of the step
  /// Pairs that come this near within this time, at the speed they have, are contacts too [s].
  double look_ahead = 0;
  double skin = 0.3;                  ///< of the neighbour list
  double solver_penetration = 1e-4;   ///< that a step may add by an unfinished contact solution
  double wall_force_floor = 0;        ///< what the force on a wall counts as at least [N/m]
  contact::DiskSolverSettings solver; ///< its penetration_tolerance is set from solver_penetration

  /// Law of these contacts; null: Coulomb's.
  std::shared_ptr<const ContactLaw> contact_law;

  bool any_rolling() const { return rolling_resistance > 0. || inner_rolling_resistance > 0.; }
  /// Whether rotations of the primaries matter.
  bool rotations() const;
  /// Gap beyond which no pair counts as near, however fast it closes [mean diameters].
  double reach() const;
};
} // namespace softgrain::bpm

#endif
