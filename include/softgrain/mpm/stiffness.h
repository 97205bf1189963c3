// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stiffness_h
#define softgrain_mpm_stiffness_h

#include <softgrain/mpm/body.h>

namespace softgrain::mpm
{
class SystemMatrix;

/**
 * @brief Stiffness -d(internal force)/d(displacement) for the stress and tangent last evaluated, times @p
 * factor, added.
 * @param guard_rotation whether to leave the exact tangent and add what keeps a compressed free body from
 * having a negative stiffness against rotation; what holds it in truth are its contacts, which the matrix
 * does not know. Newton then converges linearly, at a rate of about mean pressure over modulus.
 */
template <int dim>
void add_stiffness(const Body<dim> &body, double factor, bool guard_rotation, SystemMatrix &matrix);
} // namespace softgrain::mpm

#endif
