// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/body_inertia.h>
#include <softgrain/mpm/stepping/body_resistance.h>
#include <softgrain/mpm/stepping/quasi_static.h>
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/time_integrator.h>
#include <softgrain/mpm/stepping/time_scheme.h>

#include <sstream>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::mpm::TimeIntegrator)

namespace softgrain::mpm
{
std::unique_ptr<BodyTerms<2>> TimeIntegrator::terms_of(const BodyStart &start) const
{
  auto inertia = std::make_unique<BodyInertia<2>>();
  inertia->begin(start.body, start.scheme, start.plan.dt, start.nothing_turns_it, start.load);
  return inertia;
}

StepOutcome TimeIntegrator::settle(const Problem &, State &, Workspace &, double) const
{
  StepOutcome nothing;
  nothing.accepted = true;
  return nothing;
}

std::string TimeScheme::in_words() const
{
  if (steps != Steps::implicit_motion)
    return name;
  std::ostringstream text;
  text << name << ", theta " << theta;
  return text.str();
}

void TimeScheme::check_step(const double step, const double cfl) const
{
  if (solves_equations() || step <= cfl)
    return;
  std::ostringstream message;
  message << "'Time/Time step' = " << step << " s is not allowed with 'Time/Scheme' = '" << name
          << "': it must be below the CFL step of " << cfl << " s";
  throw InputError(message.str());
}

TimeScheme TimeScheme::create(const std::string &name, const double theta)
{
  if (!(theta >= 0.5 && theta <= 1.))
    throw InputError("'Time/Theta' = " + std::to_string(theta) +
                     " is not allowed: a number from 0.5 to 1 is needed");
  const std::shared_ptr<const TimeIntegrator> integrator = Registry<TimeIntegrator>::instance().create(name);
  TimeScheme scheme = integrator->terms(theta);
  scheme.name = name;
  scheme.integrator = integrator;
  return scheme;
}

namespace
{
/// Schemes that differ in their terms alone.
class ImplicitWithInertia : public TimeIntegrator
{
public:
  StepOutcome
  step(const Problem &problem, State &state, Workspace &work, const double dt, double) const override
  {
    return implicit_step(problem, state, work, {dt, false, 0.});
  }
};

class MoreauJean final : public ImplicitWithInertia
{
public:
  TimeScheme terms(const double theta) const override
  {
    return {"", theta, TimeScheme::Steps::implicit_motion, {}};
  }
  bool in_space() const override { return true; }
};

class Newmark final : public ImplicitWithInertia
{
public:
  TimeScheme terms(double) const override { return {"", 0.5, TimeScheme::Steps::implicit_motion, {}}; }
};

class SymplecticEuler final : public TimeIntegrator
{
public:
  TimeScheme terms(double) const override { return {"", 1., TimeScheme::Steps::explicit_motion, {}}; }
  bool in_space() const override { return true; }
  StepOutcome
  step(const Problem &problem, State &state, Workspace &work, const double dt, double) const override
  {
    return explicit_step(problem, state, work, dt);
  }
};

class QuasiStatic final : public TimeIntegrator
{
public:
  TimeScheme terms(double) const override { return {"", 1., TimeScheme::Steps::balance, {}}; }
  bool in_space() const override { return true; }
  std::unique_ptr<BodyTerms<2>> terms_of(const BodyStart &start) const override
  {
    return std::make_unique<BodyResistance>(start);
  }
  /// From which the next step sets out.
  Eigen::VectorXd kept(const BodyEnd &end) const override
  {
    return end.plan.held ? end.before.nodes.kept : end.rate;
  }
  StepOutcome step(const Problem &problem,
                   State &state,
                   Workspace &work,
                   const double dt,
                   const double wanted) const override
  {
    return quasi_static_step(problem, state, work, dt, wanted);
  }
  StepOutcome settle(const Problem &problem, State &state, Workspace &work, const double dt) const override
  {
    return find_balance(problem, state, work, dt);
  }
};

template <typename Member>
bool add(const std::string &name, const std::string &description)
{
  return Registry<TimeIntegrator>::instance().add(name, description,
                                                  [] { return std::make_unique<Member>(); });
}

[[maybe_unused]] const bool registered[] = {
    add<MoreauJean>("moreau_jean", "theta scheme of contact dynamics"),
    add<Newmark>("newmark", "the thesis, (3.14)-(3.22)"),
    add<SymplecticEuler>("explicit", "symplectic Euler"), add<QuasiStatic>("quasi_static", "no inertia")};
} // namespace
} // namespace softgrain::mpm
