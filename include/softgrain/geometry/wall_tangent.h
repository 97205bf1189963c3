// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_wall_tangent_h
#define softgrain_geometry_wall_tangent_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace softgrain
{
/// The unit vector along which a wall slides: its normal turned by -90 degrees in the plane; in space the
/// direction of the wall that is nearest to x, or to y where the wall looks along x.
template <int dim>
dealii::Tensor<1, dim> wall_tangent(const dealii::Tensor<1, dim> &normal)
{
  if constexpr (dim == 2)
    return dealii::Tensor<1, dim>({normal[1], -normal[0]});
  dealii::Tensor<1, dim> along;
  along[std::abs(normal[0]) > 0.9 ? 1 : 0] = 1.;
  along -= (along * normal) * normal;
  return along / along.norm();
}
} // namespace softgrain

#endif
