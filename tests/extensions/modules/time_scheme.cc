// SPDX-License-Identifier: LGPL-2.1-or-later
// Backward Euler: what it gives must be what moreau_jean gives with Theta = 1. And generalised-alpha
// @cite chung1993, whose equation no choice of Theta is: its nodes have an acceleration that lasts.
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/time_integrator.h>

using namespace softgrain;

namespace
{
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

constexpr double radius = 0.5; ///< spectral, of what steps do not resolve
constexpr double alpha_m = (2. * radius - 1.) / (radius + 1.), alpha_f = radius / (radius + 1.),
                 newmark_gamma = 0.5 - alpha_m + alpha_f,
                 newmark_beta = 0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f),
                 theta = newmark_beta / newmark_gamma;

/// The acceleration at the start of a step: what the last one has left, or at first that of the forces.
Eigen::VectorXd acceleration(const mpm::Body<2> &body, const Eigen::VectorXd &load)
{
  if (body.nodes.kept.size() > 0)
    return body.nodes.kept;
  Eigen::VectorXd a = body.nodes.internal_force;
  if (load.size() > 0)
    a += load;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    a.segment<2>(2 * i) /= body.nodes.mass[i];
  return a;
}

/// With a⁺ = (v⁺ - v) / (γ Δt) - (1-γ)/γ a for the acceleration at the end,
///
///     M [(1-α_m) a⁺ + α_m a] = (1-α_f) f⁺ + α_f f + f_ext,   u = Δt [(1-θ) v + θ v⁺] + Δt² (1/2 - θ) a
class AlphaTerms final : public mpm::BodyTerms<2>
{
public:
  explicit AlphaTerms(const mpm::BodyStart &start)
      : dt(start.plan.dt)
      , rotation(whole_rotation(start.body))
      , a(acceleration(start.body, start.load))
      , load(start.load)
  {
  }

  Eigen::VectorXd increment(const mpm::Body<2> &body, const Eigen::VectorXd &v) const override
  {
    return dt * ((1. - theta) * body.nodes.velocity + theta * v) + dt * dt * (0.5 - theta) * a;
  }
  Eigen::VectorXd end_velocity(const mpm::Body<2> &body, const Eigen::VectorXd &way) const override
  {
    return (way / dt - (1. - theta) * body.nodes.velocity - dt * (0.5 - theta) * a) / theta;
  }
  void note_load(const mpm::Body<2> &, const Eigen::VectorXd &now) override { load = now; }
  void find_missing(const mpm::Body<2> &body,
                    const Eigen::VectorXd &v,
                    const Eigen::VectorXd &,
                    const Eigen::VectorXd &internal,
                    const Eigen::VectorXd &,
                    Eigen::VectorXd &missing) override
  {
    missing = known_impulse(body, internal) - times_mass(body, v - body.nodes.velocity);
  }

  double stiffness_weight() const override { return share * (1. - alpha_f) * theta * dt * dt; }
  void add_mass(const mpm::Body<2> &body, SystemMatrix &matrix) const override
  {
    matrix.add_mass<2>(body.nodes.mass, 1.);
  }
  double held_weight(const mpm::Body<2> &, const mpm::StepState<2> &) const override { return 0.; }
  const mpm::WholeRotation<2> &held() const override { return rotation; }
  const mpm::WholeRotation<2> &turn() const override { return rotation; }

  double damping(const mpm::Body<2> &body,
                 const Eigen::VectorXd &v,
                 const Eigen::VectorXd &increment,
                 const Eigen::VectorXd &internal) const override
  {
    const Eigen::VectorXd rate = increment / dt, mean = 0.5 * (v + body.nodes.velocity);
    Eigen::VectorXd impulse = 0.5 * dt * (internal + body.nodes.internal_force);
    if (load.size() > 0)
      impulse += dt * load;
    return times_mass(body, v - body.nodes.velocity).dot(rate - mean) +
           (impulse - known_impulse(body, internal)).dot(rate);
  }
  double regularisation_work(const mpm::Body<2> &, const Eigen::VectorXd &) const override { return 0.; }

private:
  static constexpr double share = newmark_gamma / (1. - alpha_m);

  static Eigen::VectorXd times_mass(const mpm::Body<2> &body, Eigen::VectorXd vector)
  {
    for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
      vector.segment<2>(2 * i) *= body.nodes.mass[i];
    return vector;
  }
  /// All impulses but those of contacts.
  Eigen::VectorXd known_impulse(const mpm::Body<2> &body, const Eigen::VectorXd &internal) const
  {
    Eigen::VectorXd impulse = dt * share * ((1. - alpha_f) * internal + alpha_f * body.nodes.internal_force) +
                              dt * (1. - newmark_gamma - share * alpha_m) * times_mass(body, a);
    if (load.size() > 0)
      impulse += dt * share * load;
    return impulse;
  }

  const double dt;
  const mpm::WholeRotation<2> rotation;
  const Eigen::VectorXd a;
  Eigen::VectorXd load;
};

class GeneralisedAlpha final : public mpm::TimeIntegrator
{
public:
  mpm::TimeScheme terms(double) const override
  {
    mpm::TimeScheme scheme;
    scheme.theta = theta;
    return scheme;
  }
  std::unique_ptr<mpm::BodyTerms<2>> terms_of(const mpm::BodyStart &start) const override
  {
    return std::make_unique<AlphaTerms>(start);
  }
  Eigen::VectorXd kept(const mpm::BodyEnd &end) const override
  {
    return (end.velocity - end.before.nodes.velocity) / (newmark_gamma * end.plan.dt) -
           (1. - newmark_gamma) / newmark_gamma * acceleration(end.before, end.load);
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

template <class Member>
bool add(const std::string &name, const std::string &description)
{
  return Registry<mpm::TimeIntegrator>::instance().add(name, description,
                                                       [] { return std::make_unique<Member>(); });
}

[[maybe_unused]] const bool registered[] = {
    add<BackwardEuler>("backward_euler", "all at the end of the step"),
    add<GeneralisedAlpha>("generalised_alpha", "spectral radius 1/2")};
} // namespace
