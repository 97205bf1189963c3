// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/turned_axes.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/physics/transformations.h>

namespace softgrain
{
void declare_rotation(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.declare_entry("Rotation", "0, 0, 0", List(Double(), 3, 3, ","),
                    "Rotation of a body that is no sphere, whose axes lie along x, y and z before: a "
                    "vector along the axis of the rotation, as long as its angle. Units: degrees.");
}

dealii::Tensor<1, 3> rotation_of(const dealii::ParameterHandler &prm)
{
  return dealii::numbers::PI / 180. * vector_of_numbers<3>(prm.get("Rotation"));
}

dealii::Tensor<2, 3> turned_axes(const dealii::Tensor<1, 3> &rotation)
{
  const double angle = rotation.norm();
  if (angle == 0.)
    return dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      dealii::Tensor<1, 3>(rotation / angle), angle);
}
} // namespace softgrain
