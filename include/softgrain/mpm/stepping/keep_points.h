// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_keep_points_h
#define softgrain_mpm_stepping_keep_points_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

#include <vector>

namespace softgrain::mpm
{
/// What the law of a body did in a step, summed over its points [J/m^(3-dim)].
struct WorkOfLaw
{
  double loss = 0;   ///< dissipated
  double supply = 0; ///< brought in by an active law
};

/// Whether the points of any body keep a history.
template <int dim>
bool any_history(const std::vector<Body<dim>> &bodies);

/// Gives the points of a body what a step has come to: stress and history.
/// @param trial as evaluate_stress() last left it
template <int dim>
WorkOfLaw keep_points(const StepState<dim> &trial, Body<dim> &body);
} // namespace softgrain::mpm

#endif
