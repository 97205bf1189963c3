// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_present_balls_h
#define softgrain_bpm_present_balls_h

#include <softgrain/contact/disk_system.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace softgrain::bpm
{
class BallDynamics;

/// The contacts of the places that balls have now, as they are seen from outside: PresentContacts in space.
/// It looks at BallDynamics, and lives no longer.
class PresentBalls
{
public:
  explicit PresentBalls(const BallDynamics &dynamics) : dynamics(dynamics) {}

  /// Contacts with the impulses of the last step; b >= the number of balls: a wall.
  const contact::BallContacts &rows() const;
  /// Gap of every contact [m].
  const std::vector<double> &gaps() const;
  /// Pair of every contact that is not one with a wall.
  const std::vector<std::uint32_t> &pairs() const;
  /// Attraction of a listed pair, 0 when out of range or between bodies [N].
  double attraction_of(std::size_t pair) const;
  /// Deepest overlap [m].
  double penetration() const;
  /// The contact with the deepest overlap, or with @p bodies_apart that of different bodies, or with a wall;
  /// the number of contacts where nothing overlaps.
  std::size_t deepest_row(bool bodies_apart = false) const;
  /// How often neighbours have been searched.
  std::size_t lists_made() const;

private:
  const BallDynamics &dynamics;
};
} // namespace softgrain::bpm

#endif
