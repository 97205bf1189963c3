// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/cylinder_solid.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace softgrain
{
using dealii::numbers::PI;

CylinderSolid::CylinderSolid(const Place &center,
                             const double whole_radius,
                             const double height,
                             const double edge_radius,
                             const Vector &rotation)
    : RoundedSolid(center, edge_radius, rotation)
{
  set(whole_radius, height);
}

void CylinderSolid::set(const double whole_radius, const double height)
{
  core_radius = whole_radius - radius;
  half_core = 0.5 * height - radius;
}

void CylinderSolid::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  declare_edges(prm);
  prm.declare_entry("Radius", "0", Double(0), "Radius of a ball or of a cylinder. Units: m.");
  prm.declare_entry("Height", "0", Double(0), "Height of a cylinder, along z before it is turned. Units: m.");
}

void CylinderSolid::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_edges(prm, body_center);
  set(prm.get_double("Radius"), prm.get_double("Height"));
}

void CylinderSolid::check(const std::string &body) const
{
  for (const auto &[name, told, rim] : {std::tuple("Radius", core_radius + radius, radius),
                                        std::tuple("Height", 2. * (half_core + radius), 2. * radius)})
    if (!(told > 0. && told >= rim))
    {
      std::ostringstream text;
      text << "'" << body << '/' << name << "' = '" << told << "' is not allowed: it must be "
           << (rim > 0. ? "at least " : "greater than ") << rim << " m, where 'Edge radius' is " << radius
           << " m";
      throw InputError(text.str());
    }
  check_edges(body, "Radius, Height");
}

double CylinderSolid::volume() const
{
  const double R = core_radius, h = 2. * half_core, r = radius;
  return PI * R * R * h + 2. * PI * R * (R + h) * r + (PI * h + PI * PI * R) * r * r +
         4. / 3. * PI * r * r * r;
}

CylinderSolid::Vector CylinderSolid::off_core(Vector at) const
{
  const double from_axis = std::hypot(at[0], at[1]),
               off = from_axis > core_radius ? 1. - core_radius / from_axis : 0.;
  at[0] *= off;
  at[1] *= off;
  at[2] -= std::clamp(at[2], -half_core, half_core);
  return at;
}

CylinderSolid::Vector CylinderSolid::from_core(const Place &x) const
{
  return turn * off_core((x - center) * turn);
}

double CylinderSolid::depth_in_core(const Place &x) const
{
  const Vector at = (x - center) * turn;
  return std::max(0., std::min(core_radius - std::hypot(at[0], at[1]), half_core - std::abs(at[2])));
}

double CylinderSolid::reach_of_core() const
{
  return std::hypot(core_radius, half_core);
}

/// The side bends about the axis, a rim along itself as well, and an end does not.
dealii::Tensor<2, 3> CylinderSolid::turn_of_normal(const Place &x) const
{
  const Vector at = (x - center) * turn, off = off_core(at), n = off / off.norm();
  dealii::Tensor<2, 3> in_own;
  const double from_axis = std::hypot(at[0], at[1]);
  if (from_axis > core_radius)
  {
    const Vector about({-at[1] / from_axis, at[0] / from_axis, 0.});
    in_own += std::hypot(n[0], n[1]) / from_axis * outer_product(about, about);
    if (off[2] != 0.)
    {
      const Vector along = cross_product_3d(n, about);
      in_own += outer_product(along, along) / radius;
    }
  }
  else if (core_radius == 0.)
    for (unsigned int d = 0; d < 2; ++d)
      in_own[d][d] = 1. / radius; // the pole of a round end
  return turn * in_own * transpose(turn);
}

std::pair<double, double> CylinderSolid::distances_from_plane(const Place &point, const Vector &normal) const
{
  const Vector n = normal * turn;
  const double middle = (center - point) * normal,
               reach = core_radius * std::hypot(n[0], n[1]) + half_core * std::abs(n[2]) + radius;
  return {middle - reach, middle + reach};
}

std::vector<double> CylinderSolid::numbers() const
{
  return {center[0],   center[1],   center[2], rotation[0], rotation[1],
          rotation[2], core_radius, half_core, radius};
}

CylinderSolid::Vector CylinderSolid::extents() const
{
  return Vector({core_radius + radius, core_radius + radius, half_core + radius});
}

double CylinderSolid::beyond_extents() const
{
  return std::max(1., std::hypot(core_radius / (core_radius + radius), half_core / (half_core + radius)));
}

namespace
{
[[maybe_unused]] const bool registered =
    Registry<Shape<3>>::instance().add("cylinder",
                                       "Radius, Height, Edge radius and Rotation: flat ends and round rims",
                                       [] { return std::make_unique<CylinderSolid>(); });
} // namespace
} // namespace softgrain
