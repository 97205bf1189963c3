// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_present_contacts_h
#define softgrain_bpm_present_contacts_h

#include <softgrain/contact/disk_system.h>
#include <softgrain/contact/neighbour_list.h>
#include <softgrain/geometry/periodic_cell.h>

#include <cstddef>
#include <vector>

namespace softgrain::bpm
{
class Dynamics;

/// The contacts and neighbours of the places that primaries have now, as they are seen from outside. It looks
/// at Dynamics, and lives no longer.
class PresentContacts
{
public:
  explicit PresentContacts(const Dynamics &dynamics) : dynamics(dynamics) {}

  /// Contacts with the impulses of the last step; b >= the number of disks: a wall, and obstacles after the
  /// walls.
  const contact::DiskContacts &rows() const;
  /// Gap of every contact [m].
  const std::vector<double> &gaps() const;
  /// Whether a row pushes, or pulls because it adheres.
  bool carries_force(std::size_t row) const;
  /// Image of its second body that a row is a contact with; not one with a wall.
  PeriodicCell<2>::Image image_of_row(std::size_t row) const;
  /// Attraction of a listed pair, 0 when out of range or between bodies [N/m].
  double attraction_of(std::size_t pair) const;
  /// Deepest overlap [m].
  double penetration() const;
  /// Pairs of primaries that are near each other.
  const contact::NeighbourList &neighbours() const;
  /// How often they have been searched.
  std::size_t lists_made() const;

private:
  const Dynamics &dynamics;
};
} // namespace softgrain::bpm

#endif
