// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/polyhedron.h>
#include <softgrain/geometry/turned_axes.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace softgrain
{
namespace
{
constexpr unsigned int most_vertices = 100; ///< the search for faces looks at all triples of them
constexpr double most_slender = 10.;
constexpr unsigned int most_iterations = 60;
constexpr double rounding = 1e-15; ///< of a place on a ray, over its distance
} // namespace

Polyhedron::Polyhedron(const Place &center,
                       std::vector<Vector> told,
                       const double edge_radius,
                       const Vector &rotation)
    : ConvexSolid(center, rotation), vertices(std::move(told)), radius(edge_radius)
{
  find_hull();
}

/// Its inner centre is the mean of the corners, wherever they are told from. What check() will refuse is a
/// ball until then.
void Polyhedron::find_hull()
{
  std::vector<Place> placed;
  for (const Vector &vertex : vertices)
    placed.push_back(center + turn * vertex);
  if (placed.empty() || placed.size() > most_vertices)
    placed = {center};
  hull = ConvexHull(placed);
  Vector sum;
  for (const Place &corner : hull.corners)
    sum += corner - Place();
  center = Place(sum / static_cast<double>(hull.corners.size()));
}

void Polyhedron::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  declare_rotation(prm);
  prm.declare_entry("Vertices", "", List(List(Double(), 3, 3, ","), 0, List::max_int_value, ";"),
                    "Corners of a polyhedron in any order, from its center and before it is turned, "
                    "\"x1, y1, z1; x2, y2, z2; ...\": the body is convex. Two corners are a rod, four of a "
                    "plane a plate. Units: m.");
  prm.declare_entry("Edge radius", "0", Double(0),
                    "Radius by which a polyhedron is larger than its Vertices tell, on all sides; edges and "
                    "corners are round with it. Units: m.");
}

void Polyhedron::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_place(prm, body_center);
  vertices = list_of_vectors<3>(prm.get("Vertices"));
  radius = prm.get_double("Edge radius");
  find_hull();
}

void Polyhedron::check(const std::string &body) const
{
  if (vertices.empty() || vertices.size() > most_vertices)
    throw InputError("'" + body + "/Vertices' has " + std::to_string(vertices.size()) +
                     " points: a polyhedron has from 1 to " + std::to_string(most_vertices));
  if (!(radius > 0.))
    throw InputError("'" + body + "/Edge radius' = '" + std::to_string(radius) +
                     "' is not allowed: it must be greater than 0, as edges are round");
  const Vector extent = extents();
  const auto [least, greatest] = std::minmax({extent[0], extent[1], extent[2]});
  if (greatest > most_slender * least)
  {
    std::ostringstream text;
    text << "'" << body << "/Vertices' make the body " << 2. * greatest << " m long and " << 2. * least
         << " m wide along its axes: at most ten times as long is allowed";
    throw InputError(text.str());
  }
}

double Polyhedron::depth(const Place &p) const
{
  if (const double inside = hull.depth(p); inside > 0.)
    return radius + inside;
  return radius - hull.foot(p).off.norm();
}

/// Newton's method on the ray, on which the distance from the hull is convex: it comes from beyond.
SurfacePlace<3> Polyhedron::place(const Place &x) const
{
  const Vector ray = (x - center) / (x - center).norm();
  double along = (x - center).norm();
  if (!(depth(x) < 0.5 * radius))
  {
    along = radius;
    for (const Place &corner : hull.corners)
      along = std::max(along, radius + corner.distance(center));
  }
  ConvexHull::Foot foot = hull.foot(center + along * ray);
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    const double distance = foot.off.norm(), move = (radius - distance) * distance / (foot.off * ray);
    along += move;
    foot = hull.foot(center + along * ray);
    if (std::abs(move) <= rounding * along)
      break;
  }
  SurfacePlace<3> result = place_of(center + along * ray, foot.off / foot.off.norm());
  if (foot.on == ConvexHull::Foot::On::face)
    return result;
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      result.bend[i][j] =
          ((i == j ? 1. : 0.) - (result.tangent[i] * foot.along) * (result.tangent[j] * foot.along)) / radius;
  return result;
}

double Polyhedron::volume() const
{
  using dealii::numbers::PI;
  double of_edges = 0.;
  for (const ConvexHull::Edge &edge : hull.edges)
    of_edges += 0.5 * edge.turn * hull.corners[edge.ends[0]].distance(hull.corners[edge.ends[1]]);
  return hull.volume() + hull.area() * radius + of_edges * radius * radius +
         4. / 3. * PI * radius * radius * radius;
}

std::pair<double, double> Polyhedron::distances_from_plane(const Place &point, const Vector &normal) const
{
  double least = std::numeric_limits<double>::max(), greatest = -least;
  for (const Place &corner : hull.corners)
  {
    least = std::min(least, (corner - point) * normal);
    greatest = std::max(greatest, (corner - point) * normal);
  }
  return {least - radius, greatest + radius};
}

/// Rays from the centre meet slanted faces at places that are farther apart.
TriangulatedSurface Polyhedron::surface(const double spacing) const
{
  return finely(spacing, [this](const double finer) { return ConvexSolid::surface(finer); });
}

std::vector<double> Polyhedron::numbers() const
{
  std::vector<double> all = {radius};
  for (const Place &corner : hull.corners)
    all.insert(all.end(), {corner[0], corner[1], corner[2]});
  return all;
}

Polyhedron::Vector Polyhedron::outward(const Place &p) const
{
  return hull.foot(p).off;
}

Polyhedron::Vector Polyhedron::extents() const
{
  Vector extent;
  for (unsigned int d = 0; d < 3; ++d)
  {
    Vector axis;
    for (unsigned int e = 0; e < 3; ++e)
      axis[e] = turn[e][d];
    const auto [least, greatest] = distances_from_plane(center, axis);
    extent[d] = std::max(-least, greatest);
  }
  return extent;
}

double Polyhedron::beyond_extents() const
{
  double most = 1.;
  const Vector extent = extents();
  for (const Place &corner : hull.corners)
  {
    const Vector along = (corner - center) * turn;
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      square += along[d] * along[d] / (extent[d] * extent[d]);
    most = std::max(most, std::sqrt(square));
  }
  return most;
}

namespace
{
[[maybe_unused]] const bool registered = Registry<Shape<3>>::instance().add(
    "polyhedron",
    "Vertices, Edge radius and Rotation: flat faces and round edges, also rods and plates",
    [] { return std::make_unique<Polyhedron>(); });
} // namespace
} // namespace softgrain
