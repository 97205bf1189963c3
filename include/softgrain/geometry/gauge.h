// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_gauge_h
#define softgrain_geometry_gauge_h

#include <softgrain/geometry/rest_surface.h>

#include <deal.II/base/symmetric_tensor.h>

namespace softgrain
{
/// How far out a place lies on its ray from a centre, over how far out the surface is there, with its first
/// and second derivatives at a place that is not the centre [1, 1/m, 1/m^2]. It is homogeneous of degree 1.
struct Gauge
{
  double value = 0.;
  dealii::Tensor<1, 3> gradient;
  dealii::SymmetricTensor<2, 3> hessian;
};

/// The place of the surface on the ray from @p center to @p x, where @p here is the gauge.
SurfacePlace<3> place_on_ray(const dealii::Point<3> &center, const dealii::Point<3> &x, Gauge here);
} // namespace softgrain

#endif
