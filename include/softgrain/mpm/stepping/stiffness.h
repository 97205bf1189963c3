// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_stiffness_h
#define softgrain_mpm_stepping_stiffness_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

namespace softgrain
{
class SystemMatrix;
}

namespace softgrain::mpm
{
/// Lays out @p matrix for the independent nodes of @p field and its cells with material points.
/// @param all_cells those too that only the surface reaches: rays may meet it there, and their second
/// derivatives are parts of Newton's matrix
template <int dim>
void lay_out_stiffness(const BodyField<dim> &field, SystemMatrix &matrix, bool all_cells);

/**
 * @brief Stiffness -d(internal force)/d(displacement) for the stress and tangent in @p s, times @p factor,
 * added.
 * A compressed free body has a negative stiffness against rotation: what holds it are its contacts, which
 * this matrix does not know; see RankOneSolver.
 */
template <int dim>
void add_stiffness(const Body<dim> &body, const StepState<dim> &s, double factor, SystemMatrix &matrix);
} // namespace softgrain::mpm

#endif
