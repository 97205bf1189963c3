// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/sphere_surface.h>

#include <cmath>

namespace softgrain
{
SphereSurface::Place SphereSurface::at(const dealii::Point<3> &x) const
{
  Place place;
  place.normal = x - center;
  place.normal /= place.normal.norm();
  place.position = center + radius * place.normal;
  // Tangents need be no more than at right angles to each other.
  unsigned int smallest = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(place.normal[d]) < std::abs(place.normal[smallest]))
      smallest = d;
  dealii::Tensor<1, 3> axis;
  axis[smallest] = 1.;
  place.tangent[0] = axis - place.normal[smallest] * place.normal;
  place.tangent[0] /= place.tangent[0].norm();
  place.tangent[1] = dealii::cross_product_3d(place.normal, place.tangent[0]);
  place.bend[0][0] = place.bend[1][1] = 1. / radius;
  return place;
}

SphereSurface::Place SphereSurface::move(const Place &place, const dealii::Tensor<1, 2> &way) const
{
  return at(place.position + way[0] * place.tangent[0] + way[1] * place.tangent[1]);
}
} // namespace softgrain
