// SPDX-License-Identifier: LGPL-2.1-or-later
// Backward Euler: what it gives must be what moreau_jean gives with Theta = 1.
#include <softgrain/mpm/model/world.h>
#include <softgrain/mpm/stepping/time_integrator.h>

using namespace softgrain;

class BackwardEuler final : public mpm::TimeIntegrator
{
public:
  mpm::TimeScheme terms(double) const override
  {
    mpm::TimeScheme scheme;
    scheme.theta = 1.;
    scheme.rows_follow = true;
    return scheme;
  }

  mpm::StepOutcome step(mpm::World &world, const double dt, double) const override
  {
    return implicit_step(world, {dt, false, 0.});
  }
};

[[maybe_unused]] const bool registered = Registry<mpm::TimeIntegrator>::instance().add(
    "backward_euler", "all at the end of the step", [] { return std::make_unique<BackwardEuler>(); });
