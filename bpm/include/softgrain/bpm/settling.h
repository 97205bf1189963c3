// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_settling_h
#define softgrain_bpm_settling_h

#include <softgrain/bpm/aggregate.h>

#include <memory>
#include <string>

namespace softgrain::bpm
{
/// How far an aggregate in the making comes to rest.
enum class Settling
{
  roughly, ///< enough to see which primaries reach beyond the outline; it may end while some still move
  wholly   ///< as the run begins with it
};

/**
 * @brief Moves the primaries of one aggregate by attraction and inelastic contacts alone, until they rest.
 *
 * Only the state at rest matters, not the way to there: steps are long, and all velocities are set to zero
 * whenever the kinetic energy has passed a maximum (kinetic damping of dynamic relaxation). Between two
 * maxima the primaries fall freely, so that slow motions of the whole end as soon as fast ones.
 *
 * @param aggregate its places change; more than one primary
 * @param name of the body, for the message
 * @param density [kg/m^3]
 * @param attraction what holds it together
 * @param how far
 * @throw ComputationError when it does not come to rest wholly
 */
template <int dim>
void settle(Aggregate<dim> &aggregate,
            const std::string &name,
            double density,
            const std::shared_ptr<const Attraction> &attraction,
            Settling how);

/// Moves the balls of an aggregate towards the origin, to places so many times nearer as far as the others
/// leave them room, with inelastic contacts.
void draw_together(Aggregate<3> &aggregate, double factor);
} // namespace softgrain::bpm

#endif
