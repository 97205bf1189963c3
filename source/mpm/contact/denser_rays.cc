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

} // namespace

void lay_denser_rays(const Verdict &verdict,
                     const unsigned int n_walls,
                     const double cell_size,
                     std::vector<ContactFrame<2>> &frames)
{
  const auto is_deep = [&](const ContactFrame<2> &frame)
  {
    return std::any_of(verdict.deep.begin(), verdict.deep.end(),
                       [&](const auto &overlap) {
                         return overlap.first >= deep * cell_size && is_of(frame, overlap.second, n_walls);
                       });
  };
  for (ContactFrame<2> &frame : frames)
    if (frame.corner == ContactFrame<2>::none && frame.spacing > 2. * densest * cell_size && is_deep(frame))
    {
      frame.spacing *= 0.5;
      for (ContactFrame<2>::RayPlace &ray : frame.rays)
        ray.index[0] *= 2;
    }
}
} // namespace softgrain::mpm
