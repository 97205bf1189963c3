// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_seekers_h
#define softgrain_mpm_contact_seekers_h

#include <softgrain/mpm/contact/moved_boundary.h>

#include <cstdint>

namespace softgrain::mpm
{
/// A place on a boundary that looks for contact.
struct Seeker
{
  MovedBoundary::Place at;
  double parameter;    ///< on its boundary
  unsigned int number; ///< names it from search to search
};

/// Names a row from step to step.
/// @param wall whether @p partner is a wall, or an obstacle behind the walls
inline std::uint64_t
row_key(const unsigned int body, const unsigned int marker, const unsigned int partner, const bool wall)
{
  // 24 bits for bodies, 16 for the marker, 23 for the partner: beyond that warm starts mix, results do not.
  return (static_cast<std::uint64_t>(body) << 40) | (static_cast<std::uint64_t>(marker & 0xffff) << 24) |
         (static_cast<std::uint64_t>(wall) << 23) | (partner & 0x7fffff);
}

/**
 * Calls work(seeker) for the places of a body that look for contact with what lies along @p direction from
 * its centre, as long as it says that there is something near.
 *
 * On a circle without friction they stand in space: the first where the ray along @p direction
 * leaves the body, the others a contact marker's distance apart on both sides. So a disk that turns under its
 * outline is the same disk, and touches as soon as its outline does. With friction, where material sticks,
 * and with corners, where corners must look, a boundary looks with its own markers, all of them.
 */
template <typename Work>
void for_places(const MovedBoundary &own, const MovedBoundary::Vector &direction, const Work &work)
{
  const int stride = own.boundary().contact_stride, n = own.n_markers();
  if (!own.is_free)
  {
    for (int m = 0; m < n; ++m)
      if (own.looks(m))
        work({own.place(m, 0.), static_cast<double>(m), static_cast<unsigned int>(m)});
    return;
  }
  const double first = own.facing(direction);
  const int side = n / (2 * stride);
  const auto look = [&](const int k)
  {
    const double parameter = first + k * stride;
    return work({own.place(parameter), parameter, static_cast<unsigned int>(k + 0x8000)});
  };
  for (int k = 0; k < side && look(k); ++k)
    ;
  for (int k = -1; k >= -side && look(k); --k)
    ;
}

/// Half the way to the neighbouring seekers on both sides [m].
inline double tributary_length(const MovedBoundary &own, const Seeker &seeker)
{
  if (!own.is_free)
    return own.tributary_length(seeker.number);
  const double stride = own.boundary().contact_stride;
  return 0.5 * (own.position_at(seeker.parameter + stride).distance(seeker.at.position) +
                own.position_at(seeker.parameter - stride).distance(seeker.at.position));
}
} // namespace softgrain::mpm

#endif
