// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_loads_over_step_h
#define softgrain_scene_loads_over_step_h

#include <softgrain/scene/loads.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Mean forces per mass of @p loads over a step of @p dt [s], each as mean_acceleration() has it.
 *
 * A load that sees the velocity is asked for that of the start and half of what the others change it by, so
 * that the error falls with the square of the step: what sinks in a medium ends with the right speed.
 * @param place at the start of the step
 * @param means come here, one for each load [N/kg]
 */
template <int dim>
void mean_accelerations(const std::vector<const Load<dim> *> &loads,
                        const LoadPlace<dim> &place,
                        double dt,
                        std::vector<dealii::Tensor<1, dim>> &means);
} // namespace softgrain

#endif
