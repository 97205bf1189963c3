// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_system_h
#define softgrain_contact_disk_system_h

#include <array>
#include <cstdint>
#include <type_traits>
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

/// What a body turns with, and what friction is along a contact: in the plane a number, in space a vector.
template <int dim>
using Turning = std::conditional_t<dim == 2, double, std::array<double, 3>>;

/**
 * @brief Rigid bodies as the contacts between disks or balls see them: a velocity and a mass, and a rotation
 * only where friction or rolling resistance asks for one.
 *
 * Walls are bodies too: their velocity is along their normal unless all components are prescribed, their
 * inverse mass 0 when it is prescribed. In space all walls are prescribed. Units are those of the plane; in
 * space nothing is per metre.
 */
template <int dim>
struct RoundBodies
{
  std::vector<std::array<double, dim>> velocity; ///< [m/s]
  std::vector<double> inverse_mass;              ///< [m/kg]; 0: prescribed velocity
  std::vector<Turning<dim>> angular_velocity;    ///< [rad/s]; empty: rotations do not matter
  std::vector<double>
      inverse_inertia; ///< [1/(kg m)]; empty or one per body; of walls [m/kg], along the tangent
  DiskCell cell;       ///< of contacts that know their branch, in the plane

  std::size_t size() const { return velocity.size(); }
  bool rotate() const { return !angular_velocity.empty(); }
};

using DiskBodies = RoundBodies<2>;
using BallBodies = RoundBodies<3>;

/**
 * @brief What contacts have that does not depend on the number of directions; see RoundContacts.
 *
 * Contacts are ordered by tiles: two tiles of one colour share no body, so that they may be swept at the same
 * time with the same answer for any number of threads. Contacts with walls come last and are swept one after
 * the other; there the wall is b, which feels the normal impulse alone.
 */
struct ContactOrder
{
  std::vector<std::uint32_t> a, b;  ///< indices of bodies
  std::vector<double> gap_velocity; ///< [m/s]: gap / Δt of open contacts, corrections of closed ones
  std::vector<double> friction;     ///< empty without rotations
  std::vector<double> rolling;      ///< [m]; empty: no rolling resistance; in the plane
  std::vector<double> arm_a, arm_b; ///< distance from centre to contact [m]; empty without rotations

  std::vector<double> wall_slip; ///< velocity of a wall along t, one per contact; empty: none has one; in the
                                 ///< plane [m/s]

  std::vector<double> impulse;         ///< normal, warm start in, solution out [N s/m]
  std::vector<double> rolling_impulse; ///< [N s]; empty: no rolling resistance

  std::vector<std::uint32_t> tile_start;   ///< first contact of every tile, and the first contact with a wall
  std::vector<std::uint32_t> colour_start; ///< first tile of every colour, and the number of tiles

  std::size_t size() const { return a.size(); }
};

/**
 * @brief Contacts between disks, in space balls, and walls, one entry of every vector per contact.
 *
 * Contact: `0 <= P ⟂ n·(v_a - v_b) + gap_velocity >= 0` with n the unit vector from b to a. With rotations in
 * the plane: `t = (-n_y, n_x)`, tangential velocity `t·(v_a - v_b) - arm_a ω_a - arm_b ω_b`, |P_t| <=
 * friction P; rolling velocity `ω_a - ω_b`, |P_r| <= rolling P (@cite nguyen2016, eq. (2.12)). There what
 * else of a wall moves than its velocity is in `gap_velocity`, `wall_slip` and its angular velocity. In space
 * the tangential velocity is the part across n of `v_a - v_b - (arm_a ω_a + arm_b ω_b) × n`, a vector as P_t.
 */
template <int dim>
struct RoundContacts : ContactOrder
{
  std::vector<std::array<double, dim>> normal;  ///< unit, from b to a
  std::vector<std::array<double, dim>> branch;  ///< in a cell that deforms, else empty; in the plane [m]
  std::vector<Turning<dim>> tangential_impulse; ///< [N s/m]; empty without rotations
};

using DiskContacts = RoundContacts<2>;
using BallContacts = RoundContacts<3>;
} // namespace softgrain::contact

#endif
