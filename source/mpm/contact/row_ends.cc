// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_ends.h>

namespace softgrain::mpm
{
namespace
{
using Vector = MovedBoundary::Vector;

/// Edge from the seeker's marker to the next, or from the one before to it.
Vector edge_at(const MovedBoundary &own, const unsigned int marker, const bool after)
{
  return after ? own.marker(own.boundary().next(marker)) - own.marker(marker)
               : own.marker(marker) - own.marker(own.boundary().previous(marker));
}

bool faces(const Vector &edge, const Vector &normal)
{
  return edge[0] * normal[1] - edge[1] * normal[0] > 0.5 * edge.norm();
}

bool at_corner(const MovedBoundary &own, const Seeker &seeker)
{
  return !own.is_free && own.boundary().corner[seeker.number];
}

/// Half-way to the seeker before or after.
MovedBoundary::Place end_of_row(const MovedBoundary &own, const Seeker &seeker, const bool after)
{
  if (own.is_free)
    return own.place(seeker.parameter + (after ? 0.5 : -0.5) * own.boundary().contact_stride);
  unsigned int marker = seeker.number;
  const unsigned int markers = own.markers_to_next(marker, after);
  for (unsigned int k = 0; k < markers / 2; ++k)
    marker = after ? own.boundary().next(marker) : own.boundary().previous(marker);
  if (markers % 2 == 0)
    return own.place(marker, 0.);
  return own.place(after ? marker : own.boundary().previous(marker), 0.5);
}
} // namespace

double facing_share(const MovedBoundary &own, const Seeker &seeker, const Vector &normal)
{
  if (!at_corner(own, seeker))
    return 1.;
  double facing = 0., length = 0.;
  for (const bool after : {true, false})
  {
    const Vector edge = edge_at(own, seeker.number, after);
    length += edge.norm();
    if (faces(edge, normal))
      facing += edge.norm();
  }
  return length > 0. ? facing / length : 0.;
}

void add_lift(const MovedBoundary &own,
              const Seeker &seeker,
              const std::function<double(const MovedBoundary::Place &)> &gap_at,
              ContactRow<2> &row)
{
  const bool corner = at_corner(own, seeker);
  bool looks[2];
  for (const bool after : {false, true})
  {
    looks[after] = !corner || faces(edge_at(own, seeker.number, after), row.normal);
    if (looks[after])
      row.lift[after] = gap_at(end_of_row(own, seeker, after)) - row.gap_where_found;
  }
  for (const bool after : {false, true})
    if (!looks[after])
      row.lift[after] = looks[!after] ? row.lift[!after] : 0.;
}
} // namespace softgrain::mpm
