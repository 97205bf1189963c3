// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_turned_axes_h
#define softgrain_geometry_turned_axes_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

namespace softgrain
{
/// `Rotation` of a body in space: a vector along the axis, as long as the angle.
void declare_rotation(dealii::ParameterHandler &prm);

/// What it says [rad].
dealii::Tensor<1, 3> rotation_of(const dealii::ParameterHandler &prm);

/// The axes of space, turned: the columns. @param rotation axis times angle [rad]
dealii::Tensor<2, 3> turned_axes(const dealii::Tensor<1, 3> &rotation);
} // namespace softgrain

#endif
