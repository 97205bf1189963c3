// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/obstacle_contact.h>
#include <softgrain/mpm/contact/seekers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;
using Row = ContactRow<2>;

/// Cosine of the angle between the normals of boundary and obstacle beyond which they do not face each other.
constexpr double least_facing = 0.2;
/// How far beyond a piece that goes smoothly on its seekers may be, and how near to a tip they are left to it
/// [cells].
constexpr double overhang = 0.02;
/// How deep in an obstacle a seeker is believed to be without a look at what lies between [cells].
constexpr double shallow = 0.1;

/// The place on a boundary nearest to @p x: marker, share of the way to the next one, distance.
struct Nearest
{
  unsigned int marker = 0;
  double share = 0, distance = std::numeric_limits<double>::max();
};

Nearest nearest_on(const MovedBoundary &own, const Point &x)
{
  Nearest best;
  for (unsigned int m = 0; m < own.n_markers(); ++m)
  {
    const Point &a = own.marker(m), &b = own.marker(own.boundary().next(m));
    const Vector edge = b - a;
    const double square = edge.norm_square();
    const double share = square > 0. ? std::clamp((x - a) * edge / square, 0., 1.) : 0.;
    const double distance = x.distance(a + share * edge);
    if (distance < best.distance)
      best = {m, share, distance};
  }
  return best;
}

/// Whether @p x lies within the boundary.
bool holds(const MovedBoundary &own, const Point &x)
{
  const Nearest found = nearest_on(own, x);
  const MovedBoundary::Place at = own.place(found.marker, found.share);
  return (x - at.position) * at.normal < 0.;
}
} // namespace

ObstacleContact::ObstacleContact(const ContactScene<2> &contact_scene) : scene(contact_scene)
{
  if (scene.obstacles == nullptr)
    return;
  unsigned int key = scene.walls.size();
  for (unsigned int o = 0; o < scene.obstacles->size(); ++o)
  {
    const Obstacle &obstacle = (*scene.obstacles)[o];
    const std::vector<Curve> &pieces = obstacle.description.pieces;
    Placed placed{&obstacle, obstacle.way.at(scene.share), 0.,
                  static_cast<unsigned int>(scene.walls.size()) + o, key};
    for (const Curve &piece : pieces)
      for (const Point &x : piece.line(1.6))
        placed.way = std::max(placed.way, scene.dt * obstacle.way.velocity(x).norm());
    key += 2 * pieces.size() + 1;
    list.push_back(placed);
  }
}

double ObstacleContact::largest_way() const
{
  double way = 0.;
  for (const Placed &placed : list)
    way = std::max(way, placed.way);
  return way;
}

void ObstacleContact::find(const Body<2> &body,
                           const MovedBoundary &own,
                           const double rest,
                           std::vector<Row> &rows) const
{
  for (const Placed &placed : list)
  {
    const double margin = rest + 2. * (own.travel.norm() + own.spread + placed.way);
    find_at_pieces(placed, body, own, margin, rows);
    find_at_tips(placed, body, own, margin, rows);
  }
}

Row ObstacleContact::start_row(const Placed &placed,
                               const Body<2> &body,
                               const MovedBoundary::Place &at,
                               const Vector &normal,
                               const double gap,
                               const Point &drawn) const
{
  Row row;
  row.body = body.index;
  row.wall = placed.wall;
  row.obstacle = true;
  row.dented = false;
  row.partner_velocity = placed.obstacle->way.velocity(drawn);
  row.place = at.position;
  row.normal = normal;
  row.gap_where_found = gap;
  row.gap = gap - scene.share * ((at.displacement - scene.dt * row.partner_velocity) * normal);
  row.friction = placed.obstacle->description.friction;
  return row;
}

void ObstacleContact::find_at_pieces(const Placed &placed,
                                     const Body<2> &body,
                                     const MovedBoundary &own,
                                     const double margin,
                                     std::vector<Row> &rows) const
{
  const std::vector<Curve> &pieces = placed.obstacle->description.pieces;
  for (unsigned int k = 0; k < pieces.size(); ++k)
  {
    const Point nearest = placed.pose.placed(pieces[k].foot(placed.pose.drawn(own.center)).place);
    const double wide = margin + scene.cell_size, seam = overhang * scene.cell_size;
    const bool last = k + 1 == pieces.size(), loop = last && !placed.obstacle->has_tip(k + 1);
    const bool tip_before = placed.obstacle->has_tip(k),
               tip_after = placed.obstacle->has_tip(loop ? 0 : k + 1);
    // The box of a straight piece; an arc may bulge out of that of its ends.
    const Polygon line = pieces[k].line(0.2);
    Point lower = placed.pose.placed(line.front()), upper = lower;
    for (const Point &vertex : line)
      for (unsigned int d = 0; d < 2; ++d)
      {
        const Point x = placed.pose.placed(vertex);
        lower[d] = std::min(lower[d], x[d]);
        upper[d] = std::max(upper[d], x[d]);
      }
    // Chords of 0.2 rad lie within half a per cent of the radius, which is below the size of the box.
    if (!own.near_box(lower, upper, wide + 0.01 * lower.distance(upper)))
      continue;
    for_places(own, nearest - own.center,
               [&](const Seeker &seeker)
               {
                 const MovedBoundary::Place &at = seeker.at;
                 const Curve::Foot foot = pieces[k].foot(placed.pose.drawn(at.position));
                 const Point opposite = placed.pose.placed(foot.place);
                 const bool near = at.position.distance(opposite) < wide;
                 Vector normal = placed.pose.turned(foot.normal, placed.pose.angle);
                 const double facing = normal * at.normal;
                 const bool at_tip = (tip_before && foot.place.distance(pieces[k].begin()) < seam) ||
                                     (tip_after && foot.place.distance(pieces[k].end()) < seam);
                 if (!near || foot.beyond > seam || at_tip || std::abs(facing) < least_facing)
                   return near;
                 if (facing > 0.)
                   normal *= -1.;
                 const double gap = (at.position - opposite) * normal;
                 Row row = start_row(placed, body, at, normal, gap, foot.place);
                 if (gap < -scene.cell_size || std::min(gap, row.gap) > margin)
                   return near;
                 // What went through an obstacle has it inside; beside its end the far side of a body only
                 // looks as if.
                 if (gap < -shallow * scene.cell_size && !holds(own, opposite))
                   return near;
                 row.body_weights = own.weights(seeker.parameter).shared();
                 row.length = tributary_length(own, seeker);
                 row.key = row_key(body.index, seeker.number, placed.first_key + k, true);
                 rows.push_back(std::move(row));
                 return true;
               });
  }
}

void ObstacleContact::find_at_tips(const Placed &placed,
                                   const Body<2> &body,
                                   const MovedBoundary &own,
                                   const double margin,
                                   std::vector<Row> &rows) const
{
  const Obstacle &obstacle = *placed.obstacle;
  const std::size_t n_pieces = obstacle.description.pieces.size();
  for (unsigned int k = 0; k <= n_pieces; ++k)
  {
    if (!obstacle.has_tip(k))
      continue;
    const Point drawn = obstacle.tip(k), tip = placed.pose.placed(drawn);
    if (!own.near(tip, margin))
      continue;
    const Nearest found = nearest_on(own, tip);
    if (found.distance > margin + scene.cell_size)
      continue;
    const MovedBoundary::Place at = own.place(found.marker, found.share);
    const Vector normal = -at.normal;
    const double gap = (at.position - tip) * normal;
    Row row = start_row(placed, body, at, normal, gap, drawn);
    if (std::min(gap, row.gap) > margin)
      continue;
    // Far to the side of a corner of the body: the corner looks for the piece itself.
    if (std::abs(gap) < 0.7 * found.distance && found.distance > 0.1 * scene.cell_size)
      continue;
    row.body_weights = own.weights(found.marker, found.share).shared();
    row.length = own.boundary().contact_stride *
                 own.marker(found.marker).distance(own.marker(own.boundary().next(found.marker)));
    row.key = row_key(body.index, 0, placed.first_key + n_pieces + k, true);
    rows.push_back(std::move(row));
  }
}
} // namespace softgrain::mpm
