// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/gauge.h>
#include <softgrain/geometry/solid.h>

namespace softgrain
{
SurfacePlace<3> place_on_ray(const dealii::Point<3> &center, const dealii::Point<3> &x, Gauge here)
{
  // Its slope is the same on the whole ray, and its second derivative falls with its value.
  here.hessian *= here.value;
  const double steep = here.gradient.norm();
  SurfacePlace<3> result = place_of(center + (x - center) / here.value, here.gradient / steep);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      result.bend[i][j] = result.tangent[i] * (here.hessian * result.tangent[j]) / steep;
  return result;
}
} // namespace softgrain
