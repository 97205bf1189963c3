// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_quasi_static_h
#define softgrain_mpm_stepping_quasi_static_h

#include <softgrain/mpm/stepping/step.h>

namespace softgrain::mpm
{
/**
 * @brief One step of `quasi_static`: walls and loads go on by @p dt, and bodies follow them. With walls under
 * pressure, find_balance() is part of it. See doc/theory.md, "Without inertia".
 *
 * @param wanted length of an uncut step [s]; a shorter one resists motion more, in proportion
 * @return not accepted, and nothing changed, when the bodies cannot follow the walls
 */
StepOutcome
quasi_static_step(const Problem &problem, State &state, Workspace &work, double dt, double wanted);

/**
 * @brief Held steps after a step of length @p dt [s], in which walls and loads stand, until the bodies are in
 * balance.
 * @throw ComputationError when they are not after 'Quasi-static/Held steps'; they have then moved
 */
StepOutcome find_balance(const Problem &problem, State &state, Workspace &work, double dt);

/// How far the bodies are from balance under the impulses of a step of length @p dt, along its rows: the
/// largest net force of contacts and loads on a body, over the mean force of a contact, of a pair of bodies
/// or a body and a wall (dimensionless; 0 when there are no forces). @param loads on every body [N/m]
double unbalanced_force(const Problem &problem,
                        const State &state,
                        const Workspace &work,
                        double dt,
                        const std::vector<dealii::Tensor<1, 2>> &loads);
} // namespace softgrain::mpm

#endif
