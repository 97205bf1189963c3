// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_system_h
#define softgrain_contact_disk_system_h

#include <array>
#include <cstdint>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief A cell that deforms and takes bodies along, as the contacts between disks see it.
 *
 * Two bodies at a branch r from each other are parted by it at L r. An entry of L may be an unknown: a force
 * f at a contact then changes L_kl by f_k r_l times its inverse mass.
 */
struct DiskCell
{
  double gradient[2][2] = {{0, 0}, {0, 0}};     ///< L [1/s]
  double inverse_mass[2][2] = {{0, 0}, {0, 0}}; ///< [1/(kg m)]; 0: prescribed

  bool is_free() const
  {
    return inverse_mass[0][0] > 0. || inverse_mass[0][1] > 0. || inverse_mass[1][0] > 0. ||
           inverse_mass[1][1] > 0.;
  }
};

/**
 * @brief Rigid bodies as the contacts between disks see them: a velocity and a mass, and a rotation only
 * where friction or rolling resistance asks for one.
 *
 * Walls are bodies too: their velocity is along their normal unless both components are prescribed, their
 * inverse mass 0 when it is prescribed.
 */
struct DiskBodies
{
  std::vector<std::array<double, 2>> velocity; ///< [m/s]
  std::vector<double> inverse_mass;            ///< [m/kg]; 0: prescribed velocity
  std::vector<double> angular_velocity;        ///< [rad/s]; empty: rotations do not matter
  std::vector<double>
      inverse_inertia; ///< [1/(kg m)]; empty or one per body; of walls [m/kg], along the tangent
  DiskCell cell;       ///< of contacts that know their branch

  std::size_t size() const { return velocity.size(); }
  bool rotate() const { return !angular_velocity.empty(); }
};

/**
 * @brief Contacts between disks (and walls), one entry of every vector per contact.
 *
 * Contact: `0 <= P ⟂ n·(v_a - v_b) + gap_velocity >= 0` with n the unit vector from b to a. With rotations:
 * `t = (-n_y, n_x)`, tangential velocity `t·(v_a - v_b) - arm_a ω_a - arm_b ω_b`, |P_t| <= friction P;
 * rolling velocity `ω_a - ω_b`, |P_r| <= rolling P (@cite nguyen2016, eq. (2.12)).
 *
 * Contacts are ordered by tiles: two tiles of one colour share no body, so that they may be swept at the same
 * time with the same answer for any number of threads. Contacts with walls come last and are swept one after
 * the other; there the wall is b, which feels the normal impulse alone. What else moves than its velocity is
 * in `gap_velocity`, `wall_slip` and its angular velocity.
 */
struct DiskContacts
{
  std::vector<std::uint32_t> a, b;           ///< indices of bodies
  std::vector<std::array<double, 2>> normal; ///< unit, from b to a
  std::vector<double> gap_velocity; ///< [m/s]: gap / Δt of open contacts, corrections of closed ones
  std::vector<double> friction;     ///< empty without rotations
  std::vector<double> rolling;      ///< [m]; empty: no rolling resistance
  std::vector<double> arm_a, arm_b; ///< distance from centre to contact [m]; empty without rotations
  std::vector<std::array<double, 2>> branch; ///< in a cell that deforms, else empty [m]

  std::vector<double> wall_slip; ///< velocity of a wall along t, one per contact; empty: none has one [m/s]

  std::vector<double> impulse;            ///< normal, warm start in, solution out [N s/m]
  std::vector<double> tangential_impulse; ///< [N s/m]; empty without rotations
  std::vector<double> rolling_impulse;    ///< [N s]; empty: no rolling resistance

  std::vector<std::uint32_t> tile_start;   ///< first contact of every tile, and the first contact with a wall
  std::vector<std::uint32_t> colour_start; ///< first tile of every colour, and the number of tiles

  std::size_t size() const { return a.size(); }
};
} // namespace softgrain::contact

#endif
