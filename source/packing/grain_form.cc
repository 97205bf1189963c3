// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/packing/packing.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace softgrain
{
using dealii::numbers::PI;

std::vector<dealii::Tensor<1, 2>> GrainForm2D::directions() const
{
  std::vector<dealii::Tensor<1, 2>> result;
  for (unsigned int i = 0; i < corners; ++i)
    result.push_back(
        dealii::Tensor<1, 2>({std::cos(2. * PI * i / corners), std::sin(2. * PI * i / corners)}));
  return result;
}

double GrainForm2D::area(const double radius) const
{
  switch (kind)
  {
  case Kind::ellipse:
    return PI * radius * short_radius;
  case Kind::polygon:
    return 0.5 * corners * std::sin(2. * PI / corners) * radius * short_radius;
  default:
    return PI * radius * radius;
  }
}

double GrainForm2D::width(const double radius) const
{
  switch (kind)
  {
  case Kind::ellipse:
    return 2. * short_radius;
  case Kind::polygon:
    return 2. * short_radius * std::cos(PI / corners);
  default:
    return 2. * radius;
  }
}
} // namespace softgrain
