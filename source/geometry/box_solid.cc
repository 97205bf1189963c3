// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/box_solid.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace softgrain
{
namespace
{
/// Corners of its core, from the centre.
std::vector<dealii::Tensor<1, 3>> corners_of(const dealii::Tensor<1, 3> &size, const double radius)
{
  std::vector<dealii::Tensor<1, 3>> result;
  for (unsigned int c = 0; c < 8; ++c)
  {
    dealii::Tensor<1, 3> corner;
    for (unsigned int d = 0; d < 3; ++d)
      corner[d] = (c >> d & 1 ? 1. : -1.) * std::max(0., 0.5 * size[d] - radius);
    result.push_back(corner);
  }
  return result;
}
} // namespace

BoxSolid::BoxSolid(const Place &center, const Vector &size, const double edge_radius, const Vector &rotation)
    : Polyhedron(center, corners_of(size, edge_radius), edge_radius, rotation), size(size)
{
}

void BoxSolid::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  declare_edges(prm);
  prm.declare_entry("Size", "0, 0, 0", List(Double(0), 3, 3, ","),
                    "Edge lengths of a box along x, y and z, before it is turned. Units: m.");
}

void BoxSolid::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  parse_edges(prm, body_center);
  size = vector_of_numbers<3>(prm.get("Size"));
  set_vertices(corners_of(size, radius));
}

void BoxSolid::check(const std::string &body) const
{
  for (unsigned int d = 0; d < 3; ++d)
    if (!(size[d] > 0. && size[d] >= 2. * radius))
    {
      std::ostringstream text;
      text << "'" << body << "/Size' = '" << size[0] << ", " << size[1] << ", " << size[2]
           << "' is not allowed: each must be " << (radius > 0. ? "at least " : "greater than ")
           << 2. * radius << " m, where 'Edge radius' is " << radius << " m";
      throw InputError(text.str());
    }
  check_edges(body, "Size");
}

namespace
{
[[maybe_unused]] const bool registered =
    Registry<Shape<3>>::instance().add("box",
                                       "Size, Edge radius and Rotation: flat faces and round edges",
                                       [] { return std::make_unique<BoxSolid>(); });
} // namespace
} // namespace softgrain
