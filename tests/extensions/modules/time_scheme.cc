// SPDX-License-Identifier: LGPL-2.1-or-later
// Backward Euler: what it gives must be what moreau_jean gives with Theta = 1.
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/time_integrator.h>

using namespace softgrain;

class BackwardEuler final : public mpm::TimeIntegrator
{
public:
  mpm::TimeScheme terms(double) const override
  {
    mpm::TimeScheme scheme;
    scheme.theta = 1.;
    return scheme;
  }

  mpm::StepOutcome step(const mpm::Problem &problem,
                        mpm::State &state,
                        mpm::Workspace &work,
                        const double dt,
                        double) const override
  {
    return implicit_step(problem, state, work, {dt, false, 0.});
  }
};

[[maybe_unused]] const bool registered = Registry<mpm::TimeIntegrator>::instance().add(
    "backward_euler", "all at the end of the step", [] { return std::make_unique<BackwardEuler>(); });
