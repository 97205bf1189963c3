// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/denser_rays.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double deep = 0.05;    ///< overlap from which on rays are missed [cells]
constexpr double densest = 0.12; ///< spacing below which none is halved [cells]
constexpr double beside = 1.;    ///< way from a ray beyond which a place belongs to another frame [cells]

bool is_of(const ContactFrame<2> &frame, const Meeting &meeting, const unsigned int n_walls)
{
  constexpr unsigned int none = ContactFrame<2>::none;
  switch (meeting.with)
  {
  case Meeting::With::body:
    return frame.partner != none &&
           std::minmax(frame.body, frame.partner) == std::minmax(meeting.body, meeting.other);
  case Meeting::With::wall:
    return frame.partner == none && frame.body == meeting.body && frame.wall == meeting.other;
  default:
    return frame.partner == none && frame.body == meeting.body && frame.wall == n_walls + meeting.other;
  }
}

/// Whether the place lies under the rays of a frame, or just beside them. Where the origin lies along the
/// rays says nothing: it stays there while the contact moves.
bool is_under(const dealii::Point<2> &place, const ContactFrame<2> &frame, const double cell_size)
{
  const double offset = (place - frame.origin) * frame.across[0];
  return offset > frame.offset(frame.rays.front().index)[0] - beside * cell_size &&
         offset < frame.offset(frame.rays.back().index)[0] + beside * cell_size;
}
} // namespace

void lay_denser_rays(const Verdict &verdict,
                     const unsigned int n_walls,
                     const double cell_size,
                     std::vector<ContactFrame<2>> &frames)
{
  if (verdict.deepest.depth < deep * cell_size)
    return;
  for (ContactFrame<2> &frame : frames)
    if (frame.corner == ContactFrame<2>::none && !frame.rays.empty() &&
        frame.spacing > 2. * densest * cell_size && is_of(frame, verdict.overlap, n_walls) &&
        is_under(verdict.deepest.place, frame, cell_size))
    {
      frame.spacing *= 0.5;
      for (ContactFrame<2>::RayPlace &ray : frame.rays)
        ray.index[0] *= 2;
    }
}
} // namespace softgrain::mpm
