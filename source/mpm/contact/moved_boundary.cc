// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/moved_boundary.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Point = MovedBoundary::Point;
using Vector = MovedBoundary::Vector;

/// Unit outward normal of the edge from @p a to @p b; the solid lies to the left.
Vector edge_normal(const Point &a, const Point &b)
{
  const Vector edge = b - a;
  const double norm = edge.norm();
  return norm > 0. ? Vector({edge[1] / norm, -edge[0] / norm}) : Vector();
}

Vector at_marker(const NodeWeightsView &weights, const Eigen::VectorXd &nodal)
{
  Vector value;
  for (unsigned int k = 0; k < weights.size; ++k)
    for (unsigned int d = 0; d < 2; ++d)
      value[d] += weights.weight[k] * nodal[2 * weights.node[k] + d];
  return value;
}

/// Way of a marker that goes on as its body does, for a time @p dt [m].
Vector way_of_marker(const Body<2> &body, const unsigned int marker, const double dt)
{
  return body.velocity.size() > 0 ? dt * at_marker(body.field.marker_weights(marker), body.velocity)
                                  : Vector();
}

/// Times @p scale, the cubic of t that is 0 at 0 and at 1 and has these slopes there.
double cubic(const double scale, const double t, const double begin, const double end)
{
  const double rest = 1. - t;
  return scale * t * rest * (begin * rest - end * t);
}

/// Slope of the cubic, for a scale of 1.
double cubic_slope(const double t, const double begin, const double end)
{
  return begin * (1. - t) * (1. - 3. * t) - end * t * (2. - 3. * t);
}

/// The cubic from 0 at 0 to 1 at 1 with these slopes there, and its slope.
double share_at(const double t, const double begin, const double end)
{
  return t * t * (3. - 2. * t) + cubic(1., t, begin, end);
}

double rate_at(const double t, const double begin, const double end)
{
  return 6. * t * (1. - t) + cubic_slope(t, begin, end);
}
} // namespace

double largest_way(const Body<2> &body, const Eigen::VectorXd &displacement)
{
  double way = 0.;
  for (unsigned int m = 0; m < body.boundary.position.size(); m += body.boundary.contact_stride)
    way = std::max(way, at_marker(body.field.marker_weights(m), displacement).norm());
  return way;
}

NodeWeights blend(const NodeWeightsView &a, const NodeWeightsView &b, const double share)
{
  const unsigned int n_a = a.size, n_b = b.size;
  const unsigned int *const node_a = a.node, *const node_b = b.node;
  const double *const weight_a = a.weight, *const weight_b = b.weight;
  // Most nodes are those of both: merged they fit where no memory is to be asked for.
  boost::container::small_vector<unsigned int, 64> node(n_a + n_b, boost::container::default_init);
  boost::container::small_vector<double, 64> weight(n_a + n_b, boost::container::default_init);
  unsigned int n = 0;
  for (unsigned int i = 0, j = 0; i < n_a || j < n_b; ++n)
  {
    const bool first = j == n_b || (i < n_a && node_a[i] <= node_b[j]),
               second = i == n_a || (j < n_b && node_b[j] <= node_a[i]);
    node[n] = first ? node_a[i] : node_b[j];
    weight[n] = (first ? (1. - share) * weight_a[i] : 0.) + (second ? share * weight_b[j] : 0.);
    i += first;
    j += second;
  }
  return NodeWeightsView{node.data(), weight.data(), n}.copy();
}

NodeWeights weights_on_outline(const Body<2> &body, const unsigned int marker, const double share)
{
  if (share == 0.)
    return body.field.marker_weights(marker).copy();
  return blend(body.field.marker_weights(marker), body.field.marker_weights(body.boundary.next(marker)),
               share);
}

MovedBoundary::MovedBoundary(const Body<2> &body, const ContactScene<2> &scene)
    : is_free(body.boundary.circular && scene.free_places)
    , body(&body)
    , lower(std::numeric_limits<double>::max(), std::numeric_limits<double>::max())
    , upper(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest())
{
  find_center(scene);
  find_displacements(scene);
  move_markers(scene);
  for (unsigned int m = 0; m < position.size(); ++m)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], position[m][d]);
      upper[d] = std::max(upper[d], position[m][d]);
    }
    // Not of the nodes: those on the rim may be fast and move nothing.
    if (m % body.boundary.contact_stride == 0)
      spread = std::max(spread, (displacement[m] - travel).norm());
  }
}

void MovedBoundary::find_normals()
{
  normals.reserve(position.size());
  for (unsigned int l = 0; l < body->boundary.n_loops(); ++l)
  {
    const unsigned int begin = body->boundary.loop_start[l], end = body->boundary.loop_start[l + 1];
    Vector before = edge_normal(position[end - 1], position[begin]);
    for (unsigned int m = begin; m < end; ++m)
    {
      const Vector after = edge_normal(position[m], position[m + 1 == end ? begin : m + 1]);
      const Vector sum = before + after;
      const double norm = sum.norm();
      normals.push_back(norm > 0. ? sum / norm : sum);
      before = after;
    }
  }
}

MovedBoundary::Sketch MovedBoundary::sketch() const
{
  return {{center[0], center[1], start[0], start[1], travel[0], travel[1], nodal_travel[0], nodal_travel[1],
           spread, lower[0], lower[1], upper[0], upper[1]}};
}

MovedBoundary::MovedBoundary(const Body<2> &body, const Sketch &sketch)
    : center(sketch[0], sketch[1])
    , start(sketch[2], sketch[3])
    , travel({sketch[4], sketch[5]})
    , nodal_travel({sketch[6], sketch[7]})
    , spread(sketch[8])
    , body(&body)
    , lower(sketch[9], sketch[10])
    , upper(sketch[11], sketch[12])
{
}

void MovedBoundary::take_markers(const ContactScene<2> &scene, const double *const displacements)
{
  is_free = body->boundary.circular && scene.free_places;
  displacement.resize(body->boundary.position.size());
  std::copy_n(displacements, 2 * displacement.size(), displacement[0].begin_raw());
  move_markers(scene);
}

void MovedBoundary::find_displacements(const ContactScene<2> &scene)
{
  const Vector taken = scene.cell != nullptr ? scene.dt * scene.cell->velocity(start) : Vector();
  displacement.reserve(body->boundary.position.size());
  for (unsigned int m = 0; m < body->boundary.position.size(); ++m)
  {
    Vector moved = body->driven ? scene.dt * scene.drive[body->index]
                   : scene.increment == nullptr
                       ? way_of_marker(*body, m, scene.dt)
                       : at_marker(body->field.marker_weights(m), (*scene.increment)[body->index]);
    if (scene.cell != nullptr)
      moved += taken;
    displacement.push_back(moved);
  }
}

void MovedBoundary::move_markers(const ContactScene<2> &scene)
{
  position = body->boundary.position;
  const Point start_center = center - scene.share * travel;
  double along = 0., across = 0.;
  for (unsigned int m = 0; m < position.size(); ++m)
  {
    const Vector &moved = displacement[m];
    const Vector arm = position[m] - start_center, after = arm + moved - travel;
    along += arm * after;
    across += arm[0] * after[1] - arm[1] * after[0];
    position[m] += scene.share * moved;
  }
  const double length = std::hypot(along, across);
  if (!body->driven && length != 0. && scene.share != 0. && scene.share != 1.)
  {
    // Chords cut the corners of circles: drawn along them, a body that turns is smaller on its way.
    const double grow = 1. / std::sqrt(1. - 2. * scene.share * (1. - scene.share) * (1. - along / length));
    for (Point &x : position)
      x = center + grow * (x - center);
  }
  if (scene.places_only)
    return;
  find_normals();
  if (!is_free)
    find_looking(scene);
}

void MovedBoundary::find_center(const ContactScene<2> &scene)
{
  if (body->driven)
  {
    travel = scene.dt * scene.drive[body->index];
    return; // nobody asks where the centre of such a body is
  }
  Vector moment, way;
  for (unsigned int i = 0; i < body->mass.size(); ++i)
  {
    const Point &at = body->field.position(body->field.node_of_independent(i));
    for (unsigned int d = 0; d < 2; ++d)
    {
      moment[d] += body->mass[i] * (at[d] + body->displacement[2 * i + d]);
      if (scene.increment != nullptr)
        way[d] += body->mass[i] * (*scene.increment)[body->index][2 * i + d];
      else if (body->velocity.size() > 0)
        way[d] += body->mass[i] * (scene.dt * body->velocity[2 * i + d]);
    }
  }
  const double mass = body->mass.sum();
  travel = nodal_travel = way / mass;
  if (scene.cell != nullptr)
  {
    start = Point(moment / mass);
    travel += scene.dt * scene.cell->velocity(start);
  }
  center = Point(moment / mass + scene.share * travel);
}

void MovedBoundary::shift(const Vector &way, const Vector &moves, const double share)
{
  const Vector here = way + share * moves;
  for (Point &x : position)
    x += here;
  for (Vector &u : displacement)
    u += moves;
  for (Point *x : {&lower, &upper, &center})
    *x += here;
  start += way;
  travel += moves;
}

double MovedBoundary::Arc::height(const double share) const
{
  return cubic(length, share, start_slope, end_slope);
}

double MovedBoundary::Arc::height_change(const double share) const
{
  return length * cubic_slope(share, start_slope, end_slope);
}

MovedBoundary::Arc MovedBoundary::arc(const unsigned int m) const
{
  const unsigned int next = body->boundary.next(m);
  Arc arc;
  arc.chord = position[next] - position[m];
  arc.normal = edge_normal(position[m], position[next]);
  arc.length = arc.chord.norm();
  const bool begins = body->boundary.corner[m], ends = body->boundary.corner[next];
  if (arc.length == 0. || (begins && ends))
    return arc;
  const auto slope = [&arc](const Vector &n)
  {
    const Vector tangent({-n[1], n[0]});
    // An outline that is folded by more than 60 degrees is no curve any more.
    return tangent * arc.normal / std::max(0.5, tangent * arc.chord / arc.length);
  };
  // From a corner on it is a parabola.
  arc.start_slope = begins ? -slope(normals[next]) : slope(normals[m]);
  arc.end_slope = ends ? -arc.start_slope : slope(normals[next]);
  return arc;
}

MovedBoundary::Place MovedBoundary::place(const unsigned int m, const double share) const
{
  const unsigned int next = body->boundary.next(m);
  const Arc curve = arc(m);
  Place at;
  at.position = position[m] + share * curve.chord + curve.height(share) * curve.normal;
  const Vector tangent = curve.chord + curve.height_change(share) * curve.normal;
  at.speed = tangent.norm();
  if (at_corner(m, share) || at.speed == 0.)
    at.normal = normals[share < 0.5 ? m : next];
  else
    at.normal = Vector({tangent[1], -tangent[0]}) / at.speed;
  at.displacement = (1. - share) * displacement[m] + share * displacement[next];
  return at;
}

NodeWeights MovedBoundary::weights(const unsigned int m, const double share) const
{
  return body->driven ? NodeWeights() : weights_on_outline(*body, m, share);
}

std::pair<double, double> MovedBoundary::end_rates(const unsigned int m) const
{
  const unsigned int next = body->boundary.next(m);
  const auto chord = [this](const unsigned int a, const unsigned int b)
  { return position[a].distance(position[b]); };
  const double length = chord(m, next);
  if (length == 0.)
    return {1., 1.};
  // The mean length per marker of both sides; up to a rate of 3 the share grows all the way.
  const auto rate = [length](const double beyond) { return std::min(3., 0.5 * (length + beyond) / length); };
  return {rate(chord(body->boundary.previous(m), m)), rate(chord(next, body->boundary.next(next)))};
}

MovedBoundary::OnSegment MovedBoundary::segment(const double parameter) const
{
  const double n = n_markers();
  const double inside = parameter - n * std::floor(parameter / n);
  const unsigned int m = std::min(static_cast<unsigned int>(inside), n_markers() - 1);
  const double t = std::min(inside - m, 1.);
  const auto [begin, end] = end_rates(m);
  return {m, share_at(t, begin, end), rate_at(t, begin, end)};
}

double MovedBoundary::parameter_of(const unsigned int m, const double share) const
{
  const auto [begin, end] = end_rates(m);
  double t = share, below = 0., above = 1.;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double off = share_at(t, begin, end) - share;
    if (std::abs(off) < 1e-14)
      break;
    (off > 0. ? above : below) = t;
    const double next = t - off / rate_at(t, begin, end);
    t = next > below && next < above ? next : 0.5 * (below + above);
  }
  return m + t;
}

MovedBoundary::Place MovedBoundary::place(const double parameter) const
{
  const OnSegment at = segment(parameter);
  Place result = place(at.marker, at.share);
  result.speed *= at.rate;
  return result;
}

NodeWeights MovedBoundary::weights(const double parameter) const
{
  const OnSegment at = segment(parameter);
  return weights(at.marker, at.share);
}

MovedBoundary::Point MovedBoundary::position_at(const double parameter) const
{
  const OnSegment at = segment(parameter);
  const Arc curve = arc(at.marker);
  return position[at.marker] + at.share * curve.chord + curve.height(at.share) * curve.normal;
}

std::pair<MovedBoundary::Point, MovedBoundary::Vector> MovedBoundary::on_grid(const double parameter) const
{
  const OnSegment at = segment(parameter);
  const Point &begin = body->boundary.grid_position[at.marker],
              &end = body->boundary.grid_position[body->boundary.next(at.marker)];
  return {begin + at.share * (end - begin), edge_normal(begin, end)};
}

double MovedBoundary::facing(const Vector &direction) const
{
  const auto side = [&](const unsigned int m)
  {
    const Vector arm = position[m] - center;
    return direction[0] * arm[1] - direction[1] * arm[0];
  };
  double before = side(0);
  for (unsigned int m = 0; m < n_markers(); ++m)
  {
    const double after = side(body->boundary.next(m));
    // Markers run counterclockwise: the ray is crossed from right to left.
    if (before <= 0. && after > 0. && (position[m] - center) * direction > 0.)
      return parameter_of(m, before / (before - after));
    before = after;
  }
  return 0.; // only when the centre is outside of the outline
}

bool MovedBoundary::encloses(const Point &x) const
{
  bool inside = false;
  for (unsigned int m = 0; m < n_markers(); ++m)
  {
    const Point &a = marker(m), &b = marker(boundary().next(m));
    if ((a[1] > x[1]) != (b[1] > x[1]) && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside;
}

double MovedBoundary::distance_from(const Point &point, const Vector &normal) const
{
  // The corner of the box that lies furthest against the normal.
  const Point corner(normal[0] > 0. ? lower[0] : upper[0], normal[1] > 0. ? lower[1] : upper[1]);
  return (corner - point) * normal;
}
} // namespace softgrain::mpm
