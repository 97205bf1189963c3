// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_wall_position_h
#define softgrain_analysis_wall_position_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace softgrain
{
/**
 * @brief The one number that says where a wall is [m], as `NAME_position_m` reports it for every model.
 *
 * A wall that is square to an axis has its coordinate on that axis; an inclined one its distance from the
 * origin along its normal, which is negative when the origin lies on the side of the bodies.
 */
template <int dim>
double wall_position(const dealii::Point<dim> &point, const dealii::Tensor<1, dim> &normal);
} // namespace softgrain

#endif
