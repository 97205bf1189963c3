// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/rounded_solid.h>
#include <softgrain/geometry/turned_axes.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
constexpr double most_slender = 10.;
constexpr unsigned int most_iterations = 60;
constexpr double rounding = 1e-15; ///< of a place on a ray, over its distance
} // namespace

RoundedSolid::RoundedSolid(const Place &center, const double edge_radius, const Vector &rotation)
    : ConvexSolid(center, rotation), radius(edge_radius)
{
}

void RoundedSolid::declare_edges(dealii::ParameterHandler &prm)
{
  declare_rotation(prm);
  prm.declare_entry("Edge radius", "0", dealii::Patterns::Double(0),
                    "Radius of the round edges of a polyhedron, a box or a cylinder. A polyhedron is larger "
                    "by it than its Vertices tell, on all sides; 'Size', 'Radius' and 'Height' are those of "
                    "the whole body. Units: m.");
}

void RoundedSolid::parse_edges(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_place(prm, body_center);
  radius = prm.get_double("Edge radius");
}

void RoundedSolid::check_edges(const std::string &body, const std::string &told_by) const
{
  std::ostringstream text;
  if (!(radius > 0.))
  {
    text << "'" << body << "/Edge radius' = '" << radius
         << "' is not allowed: it must be greater than 0, as edges are round";
    throw InputError(text.str());
  }
  const Vector extent = extents();
  const auto [least, greatest] = std::minmax({extent[0], extent[1], extent[2]});
  if (greatest > most_slender * least)
  {
    text << "'" << body << '/' << told_by << "' make the body " << 2. * greatest << " m long and "
         << 2. * least << " m wide along its axes: at most ten times as long is allowed";
    throw InputError(text.str());
  }
}

double RoundedSolid::depth(const Place &p) const
{
  if (const double inside = depth_in_core(p); inside > 0.)
    return radius + inside;
  return radius - from_core(p).norm();
}

/// Newton's method on the ray, on which the distance from the core is convex: it comes from beyond.
SurfacePlace<3> RoundedSolid::place(const Place &x) const
{
  const Vector ray = (x - center) / (x - center).norm();
  double along = depth(x) < 0.5 * radius ? (x - center).norm() : radius + reach_of_core();
  Vector off = from_core(center + along * ray);
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    const double distance = off.norm(), move = (radius - distance) * distance / (off * ray);
    along += move;
    off = from_core(center + along * ray);
    if (std::abs(move) <= rounding * along)
      break;
  }
  SurfacePlace<3> result = place_of(center + along * ray, off / off.norm());
  const dealii::Tensor<2, 3> turn_there = turn_of_normal(result.position);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      result.bend[i][j] = result.tangent[i] * (turn_there * result.tangent[j]);
  return result;
}

/// Rays from the centre meet slanted faces at places that are farther apart.
TriangulatedSurface RoundedSolid::surface(const double spacing) const
{
  return finely(spacing, [this](const double finer) { return ConvexSolid::surface(finer); });
}
} // namespace softgrain
