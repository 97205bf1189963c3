// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/polyhedron.h>
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
} // namespace

Polyhedron::Polyhedron(const Place &center,
                       std::vector<Vector> told,
                       const double edge_radius,
                       const Vector &rotation)
    : RoundedSolid(center, edge_radius, rotation)
{
  set_vertices(std::move(told));
}

/// Its inner centre is the mean of the corners, wherever they are told from. What check() will refuse is a
/// ball until then.
void Polyhedron::set_vertices(std::vector<Vector> told)
{
  vertices = std::move(told);
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
  declare_edges(prm);
  prm.declare_entry("Vertices", "", List(List(Double(), 3, 3, ","), 0, List::max_int_value, ";"),
                    "Corners of a polyhedron in any order, from its center and before it is turned, "
                    "\"x1, y1, z1; x2, y2, z2; ...\": the body is convex. Two corners are a rod, four of a "
                    "plane a plate. Units: m.");
}

void Polyhedron::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_edges(prm, body_center);
  set_vertices(list_of_vectors<3>(prm.get("Vertices")));
}

void Polyhedron::check(const std::string &body) const
{
  if (vertices.empty() || vertices.size() > most_vertices)
    throw InputError("'" + body + "/Vertices' has " + std::to_string(vertices.size()) +
                     " points: a polyhedron has from 1 to " + std::to_string(most_vertices));
  check_edges(body, "Vertices");
}

double Polyhedron::reach_of_core() const
{
  double reach = 0.;
  for (const Place &corner : hull.corners)
    reach = std::max(reach, corner.distance(center));
  return reach;
}

/// A corner turns in both directions, an edge across itself.
dealii::Tensor<2, 3> Polyhedron::turn_of_normal(const Place &x) const
{
  const ConvexHull::Foot foot = hull.foot(x);
  dealii::Tensor<2, 3> result;
  if (foot.on == ConvexHull::Foot::On::face)
    return result;
  const Vector n = foot.off / foot.off.norm();
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e < 3; ++e)
      result[d][e] = ((d == e ? 1. : 0.) - n[d] * n[e] - foot.along[d] * foot.along[e]) / radius;
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

std::vector<double> Polyhedron::numbers() const
{
  std::vector<double> all = {radius};
  for (const Place &corner : hull.corners)
    all.insert(all.end(), {corner[0], corner[1], corner[2]});
  return all;
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
