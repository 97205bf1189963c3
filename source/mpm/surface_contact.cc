// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/surface_contact.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;
using Row = ContactRow<2>;

/// Unit outward normal of the edge from @p a to @p b; the solid lies to the left.
Vector edge_normal(const Point &a, const Point &b)
{
  const Vector edge = b - a;
  const double norm = edge.norm();
  return norm > 0. ? Vector({edge[1] / norm, -edge[0] / norm}) : Vector();
}

/// Mean of the normals of the two edges at a marker.
Vector marker_normal(const Boundary<2> &boundary, const unsigned int m)
{
  const Point &x = boundary.position[m];
  Vector n = edge_normal(boundary.position[boundary.previous(m)], x) +
             edge_normal(x, boundary.position[boundary.next(m)]);
  const double norm = n.norm();
  return norm > 0. ? n / norm : n;
}

struct Box
{
  Point lower{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point upper{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

  void add(const Point &x)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], x[d]);
      upper[d] = std::max(upper[d], x[d]);
    }
  }
  bool near(const Point &x, const double margin) const
  {
    return x[0] > lower[0] - margin && x[0] < upper[0] + margin && x[1] > lower[1] - margin &&
           x[1] < upper[1] + margin;
  }
  bool near(const Box &other, const double margin) const
  {
    return other.upper[0] > lower[0] - margin && other.lower[0] < upper[0] + margin &&
           other.upper[1] > lower[1] - margin && other.lower[1] < upper[1] + margin;
  }
};

/// What find() works out once per body.
struct Surface
{
  Boundary<2> boundary;          ///< in the middle of the step, at the velocities of its start
  std::vector<Vector> of_marker; ///< those velocities [m/s]
  Box box;                       ///< of the boundary
  Vector velocity;               ///< of its centre of mass [m/s]
  double spread = 0.;            ///< of the velocities of its contact markers about it [m/s]
};

Vector marker_velocity(const Body<2> &body, const unsigned int m)
{
  if (body.driven)
    return body.drive;
  const NodeWeights &weights = body.field.marker_weights(m);
  Vector v;
  for (unsigned int k = 0; k < weights.node.size(); ++k)
    for (unsigned int d = 0; d < 2; ++d)
      v[d] += weights.weight[k] * body.velocity[2 * weights.node[k] + d];
  return v;
}

Surface look_at(const Body<2> &body, const double dt)
{
  Surface surface;
  surface.boundary = body.boundary;
  surface.velocity = body.driven ? body.drive : body.momentum() / body.mass.sum();
  for (unsigned int m = 0; m < body.boundary.position.size(); ++m)
  {
    const Vector v = marker_velocity(body, m);
    surface.of_marker.push_back(v);
    surface.boundary.position[m] += 0.5 * dt * v;
    surface.box.add(surface.boundary.position[m]);
    // Not of the nodes: those on the rim may be fast and move nothing.
    if (m % body.boundary.contact_stride == 0)
      surface.spread = std::max(surface.spread, (v - surface.velocity).norm());
  }
  return surface;
}

/// Gap up to which a row is needed where things come nearer at @p approach at most: twice that way, and what
/// the walls may add when they hit what was at rest.
class Reach
{
public:
  explicit Reach(const ContactScene<2> &scene) : rest(0.1 * scene.cell_size), time(2. * scene.dt)
  {
    double drive = 0.;
    for (const WallMotion<2> &wall : scene.walls)
      drive = std::max(drive, std::abs(wall.velocity));
    rest += time * drive;
  }

  double operator()(const double approach) const { return rest + time * approach; }

private:
  double rest, time;
};

/// Half the way to the neighbouring contact markers on both sides.
double tributary_length(const Boundary<2> &boundary, const unsigned int m)
{
  double length = 0.;
  unsigned int forward = m, backward = m;
  for (unsigned int k = 0; k < boundary.contact_stride; ++k)
  {
    const unsigned int f = boundary.next(forward), b = boundary.previous(backward);
    length += 0.5 * (boundary.position[f].distance(boundary.position[forward]) +
                     boundary.position[b].distance(boundary.position[backward]));
    forward = f;
    backward = b;
  }
  return length;
}

std::uint64_t
row_key(const unsigned int body, const unsigned int marker, const unsigned int partner, const bool wall)
{
  // 24 bits for bodies, 16 for the marker, 23 for the partner: beyond that warm starts mix, results do not.
  return (static_cast<std::uint64_t>(body) << 40) | (static_cast<std::uint64_t>(marker & 0xffff) << 24) |
         (static_cast<std::uint64_t>(wall) << 23) | (partner & 0x7fffff);
}

void find_wall_rows(const ContactScene<2> &scene,
                    const Reach &reach,
                    const Body<2> &body,
                    const Surface &surface,
                    std::vector<Row> &rows)
{
  for (unsigned int w = 0; w < scene.walls.size(); ++w)
  {
    const WallMotion<2> &wall = scene.walls[w];
    if (!wall.plane)
      continue;
    const double approach = std::abs(surface.velocity * wall.normal - wall.velocity) + surface.spread;
    const double margin = reach(approach);
    for (unsigned int m = 0; m < body.boundary.position.size(); m += body.boundary.contact_stride)
    {
      const double gap = (body.boundary.position[m] - wall.point) * wall.normal;
      if (gap > margin)
        continue;
      Row row;
      row.body = body.index;
      row.wall = w;
      row.body_weights = body.field.marker_weights(m);
      row.place = body.boundary.position[m];
      row.normal = wall.normal;
      row.gap = gap;
      row.length = tributary_length(body.boundary, m);
      row.friction = wall.friction;
      row.key = row_key(body.index, m, w, true);
      rows.push_back(row);
    }
  }
}

/// Place on a polyline nearest to a marker.
struct Projection
{
  double distance = std::numeric_limits<double>::max();
  unsigned int first = 0; ///< marker at the start of the segment
  double share = 0;       ///< of the way to the next one
  Vector normal;
  double gap = 0;
};

Projection project(const Point &x,
                   const Vector &own_normal,
                   const Boundary<2> &boundary,
                   const std::vector<unsigned int> &segments)
{
  Projection best;
  for (const unsigned int s : segments)
  {
    const Point &a = boundary.position[s], &b = boundary.position[boundary.next(s)];
    const Vector edge = b - a;
    const double square = edge.norm_square();
    if (square == 0.)
      continue;
    const double share = std::clamp((x - a) * edge / square, 0., 1.);
    const double distance = x.distance(a + share * edge);
    if (distance >= best.distance || edge_normal(a, b) * own_normal > 0.2)
      continue;
    best.distance = distance;
    best.first = s;
    best.share = share;
  }
  if (best.distance < std::numeric_limits<double>::max())
  {
    const unsigned int next = boundary.next(best.first);
    const Point c = boundary.position[best.first] +
                    best.share * (boundary.position[next] - boundary.position[best.first]);
    const Vector normal =
        (1. - best.share) * marker_normal(boundary, best.first) + best.share * marker_normal(boundary, next);
    best.normal = normal / normal.norm();
    best.gap = (x - c) * best.normal;
  }
  return best;
}

NodeWeights blend(const NodeWeights &a, const NodeWeights &b, const double share)
{
  // Both are in the order of their nodes.
  NodeWeights result;
  result.node.reserve(a.node.size() + b.node.size());
  result.weight.reserve(a.node.size() + b.node.size());
  for (unsigned int i = 0, j = 0; i < a.node.size() || j < b.node.size();)
  {
    const unsigned int node =
        std::min(i < a.node.size() ? a.node[i] : b.node[j], j < b.node.size() ? b.node[j] : a.node[i]);
    double weight = 0.;
    if (i < a.node.size() && a.node[i] == node)
      weight += (1. - share) * a.weight[i++];
    if (j < b.node.size() && b.node[j] == node)
      weight += share * b.weight[j++];
    result.node.push_back(node);
    result.weight.push_back(weight);
  }
  return result;
}

void find_pair_rows(const ContactScene<2> &scene,
                    const Reach &reach,
                    const Body<2> &body,
                    const Surface &own,
                    const Body<2> &partner,
                    const Surface &other,
                    std::vector<Row> &rows)
{
  const double margin = reach((own.velocity - other.velocity).norm() + own.spread + other.spread);
  if (!own.box.near(other.box, margin))
    return;
  // Segments one cell further than the margin: the nearest point of a marker within it lies on one of them.
  std::vector<unsigned int> segments;
  for (unsigned int s = 0; s < other.boundary.position.size(); ++s)
    if (own.box.near(other.boundary.position[s], margin + 2. * scene.cell_size) ||
        own.box.near(other.boundary.position[other.boundary.next(s)], margin + 2. * scene.cell_size) ||
        partner.driven)
      segments.push_back(s);
  const double friction = partner.wall != Row::none ? scene.walls[partner.wall].friction : scene.friction;
  for (unsigned int m = 0; m < own.boundary.position.size(); m += own.boundary.contact_stride)
  {
    const Point &x = own.boundary.position[m];
    if (!other.box.near(x, margin))
      continue;
    const Projection at = project(x, marker_normal(own.boundary, m), other.boundary, segments);
    // Deeper than two cells is the far side of a thin partner, not a contact.
    if (at.distance > margin + 2. * scene.cell_size || at.gap > margin)
      continue;
    // Far to the side of what it faces: the true nearest place looks the other way, and there is no contact.
    if (std::abs(at.gap) < 0.7 * at.distance && at.distance > 0.1 * scene.cell_size)
      continue;
    const unsigned int next = other.boundary.next(at.first);
    Row row;
    row.body = body.index;
    row.partner = partner.index;
    row.wall = partner.wall;
    row.body_weights = body.field.marker_weights(m);
    row.partner_weights =
        blend(partner.field.marker_weights(at.first), partner.field.marker_weights(next), at.share);
    row.place = x;
    row.normal = at.normal;
    const Vector relative =
        own.of_marker[m] - (1. - at.share) * other.of_marker[at.first] - at.share * other.of_marker[next];
    row.gap = at.gap - 0.5 * scene.dt * (relative * at.normal); // at the start, as the row sees it
    row.length = tributary_length(own.boundary, m);
    row.friction = friction;
    row.key = row_key(body.index, m, partner.index, false);
    rows.push_back(row);
  }
}

/// For every body those whose boundaries it looks for with its markers: all that are near, each pair once.
std::vector<std::vector<unsigned int>>
find_partners(const ContactScene<2> &scene, const Reach &reach, const std::vector<Surface> &surfaces)
{
  // Grown by this each, boxes overlap whenever find_pair_rows() may find a row.
  std::vector<dealii::BoundingBox<2>> boxes;
  for (const Surface &surface : surfaces)
  {
    Box box = surface.box;
    const double margin = 0.5 * reach(2. * (surface.velocity.norm() + surface.spread));
    for (unsigned int d = 0; d < 2; ++d)
    {
      box.lower[d] -= margin;
      box.upper[d] += margin;
    }
    boxes.emplace_back(std::make_pair(box.lower, box.upper));
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  std::vector<std::vector<unsigned int>> partners(boxes.size());
  for (unsigned int b = 0; b < boxes.size(); ++b)
    for (const std::size_t a :
         tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(boxes[b])))
      if (a < b)
      {
        // The lower index looks, unless it is driven: what is driven needs no rows of its own.
        const bool first = scene.bodies[a].driven, second = scene.bodies[b].driven;
        if (!first)
          partners[a].push_back(b);
        else if (!second)
          partners[b].push_back(a);
      }
  for (std::vector<unsigned int> &list : partners)
    std::sort(list.begin(), list.end());
  return partners;
}
} // namespace

void SurfaceContact::find(const ContactScene<2> &scene, std::vector<ContactRow<2>> &rows) const
{
  const std::size_t n = scene.bodies.size();
  const Reach reach(scene);
  std::vector<Surface> surfaces(n);
  parallel_for(n, 8,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   surfaces[b] = look_at(scene.bodies[b], scene.dt);
               });
  const std::vector<std::vector<unsigned int>> partners = find_partners(scene, reach, surfaces);
  std::vector<std::vector<Row>> of_body(n);
  parallel_for(n, 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                 {
                   const Body<2> &body = scene.bodies[b];
                   if (!body.driven)
                     find_wall_rows(scene, reach, body, surfaces[b], of_body[b]);
                   for (const unsigned int partner : partners[b])
                     find_pair_rows(scene, reach, body, surfaces[b], scene.bodies[partner], surfaces[partner],
                                    of_body[b]);
                 }
               });
  rows.clear();
  for (std::vector<Row> &found : of_body)
    rows.insert(rows.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
}
} // namespace softgrain::mpm
