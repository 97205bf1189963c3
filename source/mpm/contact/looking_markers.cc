// SPDX-License-Identifier: LGPL-2.1-or-later
// Which markers of an outline look for contact, and what length each stands for.
#include <softgrain/mpm/contact/moved_boundary.h>

#include <algorithm>
#include <limits>

namespace softgrain::mpm
{
namespace
{
/// Stretch of an outline from which places between those that look for contact look, too: the outline of a
/// partner that is compressed there would bulge between them.
constexpr double stretched = 1.4;
} // namespace

// Of the outline at the start of the step: while it is sought, rows neither come nor go by this. What adheres
// keeps the rows that it has, each with what it remembers.
void MovedBoundary::find_looking(const ContactScene<2> &scene)
{
  const Boundary<2> &outline = body->boundary;
  const unsigned int stride = outline.contact_stride;
  const double widest =
      scene.pairs.adhere() ? std::numeric_limits<double>::max() : stretched * outline.spacing;
  looking.assign(n_markers(), 0);
  for (unsigned int m = 0; m < n_markers(); m += stride)
  {
    const unsigned int last = m + stride - 1;
    const double length = outline.position[m].distance(outline.position[outline.next(last)]);
    unsigned int apart = stride;
    while (apart % 2 == 0 && apart * length > stride * widest)
      apart /= 2;
    for (unsigned int k = 0; k < stride; k += apart)
      looking[m + k] = 1;
  }
}

unsigned int MovedBoundary::markers_to_next(unsigned int m, const bool after) const
{
  unsigned int markers = 0;
  do
  {
    m = after ? boundary().next(m) : boundary().previous(m);
    ++markers;
  } while (!looks(m));
  return markers;
}

double MovedBoundary::tributary_length(const unsigned int m) const
{
  const unsigned int ahead = markers_to_next(m, true), behind = markers_to_next(m, false);
  double length = 0.;
  unsigned int forward = m, backward = m;
  for (unsigned int k = 0; k < std::max(ahead, behind); ++k)
  {
    const unsigned int f = k < ahead ? boundary().next(forward) : forward,
                       b = k < behind ? boundary().previous(backward) : backward;
    length += 0.5 * (position[f].distance(position[forward]) + position[b].distance(position[backward]));
    forward = f;
    backward = b;
  }
  return length;
}
} // namespace softgrain::mpm
