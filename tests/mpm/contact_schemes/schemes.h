// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_schemes_h
#define softgrain_tests_mpm_contact_schemes_schemes_h

// Time schemes, as compared by @cite doyen2011, for M a + K u = f + h r with the gap g + h·u >= 0, r >= 0 and
// one of the two zero. Every scheme says in a line what is its own; all are written for one contact, where
// the complementarity problem has a closed form.
#include "elastic_bar.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <memory>
#include <string>

namespace softgrain::schemes
{
struct Motion
{
  Eigen::VectorXd u, v;
};

class Scheme
{
public:
  Scheme(const ElasticSystem &system, const double dt) : system(system), dt(dt) {}
  virtual ~Scheme() = default;
  /// Makes one step. @return the impulse of the contact over it
  virtual double step(Motion &motion) = 0;

protected:
  using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
  /// A matrix with its answer to the contact.
  struct Solver
  {
    void set(const Eigen::SparseMatrix<double> &A, const Eigen::VectorXd &h)
    {
      factors.compute(A);
      response = factors.solve(h);
      compliance = h.dot(response);
    }
    Factors factors;
    Eigen::VectorXd response;
    double compliance = 0.;
  };

  Eigen::VectorXd force(const Eigen::VectorXd &u) const { return system.load - system.stiffness * u; }
  /// Corrects x = A⁻¹ b so that the gap @p gap of x does not become negative. @return the multiplier
  static double close(const Solver &solver, const double gap, Eigen::VectorXd &x)
  {
    const double multiplier = std::max(0., -gap / solver.compliance);
    x += multiplier * solver.response;
    return multiplier;
  }

  const ElasticSystem system;
  const double dt;
};

/// Trapezoidal rule; the contact force belongs to the accelerations at both ends of the step.
class Newmark final : public Scheme
{
public:
  Newmark(const ElasticSystem &system, const double dt) : Scheme(system, dt)
  {
    step_matrix.set(system.mass + 0.25 * dt * dt * system.stiffness, system.gap_of);
    a = Eigen::VectorXd::Constant(system.load.size(), system.load.sum() / system.mass.sum());
  }
  double step(Motion &motion) override
  {
    const Eigen::VectorXd u_star = motion.u + dt * motion.v + 0.25 * dt * dt * a;
    Eigen::VectorXd a_new = step_matrix.factors.solve(force(u_star));
    const double beta = 0.25 * dt * dt,
                 r = close(step_matrix, system.gap_at(u_star + beta * a_new) / beta, a_new),
                 impulse = 0.5 * dt * (r + r_old);
    motion.u = u_star + beta * a_new;
    motion.v += 0.5 * dt * (a + a_new);
    a = a_new;
    r_old = r;
    return impulse;
  }

private:
  Solver step_matrix;
  Eigen::VectorXd a;
  double r_old = 0.;
};

/// The contact force is that of the end for the whole step; everything else is the trapezoidal rule. @cite
/// kane1999
class Kane : public Scheme
{
public:
  Kane(const ElasticSystem &system, const double dt) : Scheme(system, dt)
  {
    step_matrix.set(system.mass + 0.25 * dt * dt * system.stiffness, system.gap_of);
    mass.set(system.mass, system.gap_of);
  }
  double step(Motion &motion) override { return dt * conserve(motion); }

protected:
  /// @return the contact force
  double conserve(Motion &motion) const
  {
    const Eigen::VectorXd a = mass.factors.solve(force(motion.u)),
                          u_star = motion.u + dt * motion.v + 0.25 * dt * dt * a;
    Eigen::VectorXd u = step_matrix.factors.solve(system.mass * u_star + 0.25 * dt * dt * system.load);
    const double r = close(step_matrix, system.gap_at(u), u) / (0.5 * dt * dt);
    motion.v += 0.5 * dt * (a + mass.factors.solve(force(u))) + dt * r * mass.response;
    motion.u = u;
    return r;
  }
  Solver step_matrix, mass;
};

/// Conserving step with the gap condition at its end, which is the one above where bodies are linear; then
/// the contact velocities jump so that contact has taken no energy. @cite laursen2002
/// Of the two jumps that do so it is the one with which the contact parts.
class LaursenLove final : public Kane
{
public:
  using Kane::Kane;
  double step(Motion &motion) override
  {
    const double before = system.gap_at(motion.u), r = conserve(motion), taken = r * before;
    if (std::abs(before) < 1e-12 || !(taken > 0.))
      return dt * r;
    const double speed = system.gap_of.dot(motion.v), W = mass.compliance,
                 jump = (-speed + std::sqrt(speed * speed + 2. * W * taken)) / W;
    motion.v += jump * mass.response;
    return dt * r + jump;
  }
};

/// The predictor u + dt v is projected on what is allowed, in the norm of the masses. @cite deuflhard2008
class ContactStabilised final : public Scheme
{
public:
  ContactStabilised(const ElasticSystem &system, const double dt) : Scheme(system, dt)
  {
    step_matrix.set(system.mass + 0.25 * dt * dt * system.stiffness, system.gap_of);
    mass.set(system.mass, system.gap_of);
  }
  double step(Motion &motion) override
  {
    Eigen::VectorXd u_star = motion.u + dt * motion.v;
    close(mass, system.gap_at(u_star), u_star);
    Eigen::VectorXd u =
        step_matrix.factors.solve(system.mass * u_star + 0.25 * dt * dt * (force(motion.u) + system.load));
    const double r = close(step_matrix, system.gap_at(u), u) / (0.5 * dt * dt);
    motion.v += dt * (mass.factors.solve(force(0.5 * (motion.u + u))) + r * mass.response);
    motion.u = u;
    return dt * r;
  }

private:
  Solver step_matrix, mass;
};

/// Theta scheme; @p positions asks for the gap at the end of the step (softgrain), else the velocity does not
/// approach where the gap in the middle of the step would be closed (Moreau and Jean).
class Theta final : public Scheme
{
public:
  Theta(const ElasticSystem &system, const double dt, const double theta, const bool positions)
      : Scheme(system, dt), theta(theta), positions(positions)
  {
    step_matrix.set(system.mass + theta * theta * dt * dt * system.stiffness, system.gap_of);
  }
  double step(Motion &motion) override
  {
    const Eigen::VectorXd u_free = motion.u + (1. - theta) * dt * motion.v;
    Eigen::VectorXd v = step_matrix.factors.solve(
        system.mass * motion.v + dt * ((1. - theta) * force(motion.u) + theta * force(u_free)));
    double impulse = 0.;
    if (positions)
      impulse = close(step_matrix, system.gap_of.dot(v) + system.gap_at(u_free) / (theta * dt), v);
    else if (system.gap_at(motion.u + 0.5 * dt * motion.v) <= 0.)
      impulse = close(step_matrix, system.gap_of.dot(v), v);
    motion.u = u_free + theta * dt * v;
    motion.v = v;
    return impulse;
  }

private:
  const double theta;
  const bool positions;
  Solver step_matrix;
};

/// Generalised-alpha, and one impulse that keeps the gap at the end of the step from being negative.
class GeneralisedAlpha : public Scheme
{
public:
  /// @param radius of the spectrum for high frequencies
  GeneralisedAlpha(const ElasticSystem &system, const double dt, const double radius)
      : Scheme(system, dt)
      , alpha_m((2. * radius - 1.) / (radius + 1.))
      , alpha_f(radius / (radius + 1.))
      , gamma(0.5 + alpha_f - alpha_m)
      , beta(0.25 * (gamma + 0.5) * (gamma + 0.5))
      , share((1. - alpha_f) / (1. - alpha_m))
  {
    step_matrix.set(system.mass + beta * dt * dt * share * system.stiffness, system.gap_of);
    mass.set(system.mass, system.gap_of);
    a = smooth = mass.factors.solve(system.load);
  }

protected:
  /// The step without what the contact does to velocities. @return what closes the gap, as close() does
  double smooth_step(Motion &motion)
  {
    const Eigen::VectorXd known = (alpha_f * smooth - alpha_m * a) / (1. - alpha_m),
                          u_star = motion.u + dt * motion.v + (0.5 - beta) * dt * dt * a;
    Eigen::VectorXd u = step_matrix.factors.solve(system.mass * (u_star + beta * dt * dt * known) +
                                                  beta * dt * dt * share * system.load);
    const double closing = close(step_matrix, system.gap_at(u), u);
    smooth = mass.factors.solve(force(u));
    const Eigen::VectorXd a_new = share * smooth + known;
    motion.v += dt * ((1. - gamma) * a + gamma * a_new);
    motion.u = u;
    a = a_new;
    return closing;
  }

  Solver mass;

private:
  const double alpha_m, alpha_f, gamma, beta, share;
  Solver step_matrix;
  Eigen::VectorXd a, smooth; ///< as the scheme carries it, and that of the equation of motion
};

/// Generalised-alpha for the smooth part; positions are corrected by one multiplier, velocities by another.
/// @cite bruls2014
class NonsmoothAlpha final : public GeneralisedAlpha
{
public:
  using GeneralisedAlpha::GeneralisedAlpha;
  double step(Motion &motion) override
  {
    return smooth_step(motion) > 0. ? close(mass, system.gap_of.dot(motion.v), motion.v) : 0.;
  }
};

/// Generalised-alpha for what is within bodies, and one impulse per step that acts as in @ref Kane: half of
/// it on the way, all of it on the velocity. Not of the literature.
class AlphaWholeStep final : public GeneralisedAlpha
{
public:
  using GeneralisedAlpha::GeneralisedAlpha;
  double step(Motion &motion) override
  {
    const double impulse = smooth_step(motion) / (0.5 * dt);
    motion.v += impulse * mass.response;
    return impulse;
  }
};

/// What softgrain takes with `Time/Theta` = 0 for steps of so many CFL steps.
inline double theta_of_softgrain(const double cfl)
{
  return cfl > 20. ? 0.8 : 0.55;
}

/// Of "softgrain", and of "softgrain 0.7" for example.
inline double theta_of(const std::string &name, const double cfl)
{
  const auto space = name.find(' ');
  return space == std::string::npos ? theta_of_softgrain(cfl) : std::stod(name.substr(space));
}

inline std::vector<std::string> scheme_names()
{
  return {"newmark", "kane", "stabilised", "alpha", "laursen_love", "moreau_jean", "softgrain"};
}

/// @param cfl the step over cell size / wave speed
inline std::unique_ptr<Scheme>
make_scheme(const std::string &name, const ElasticSystem &system, const double dt, const double cfl)
{
  if (name == "newmark")
    return std::make_unique<Newmark>(system, dt);
  if (name == "kane")
    return std::make_unique<Kane>(system, dt);
  if (name == "stabilised")
    return std::make_unique<ContactStabilised>(system, dt);
  if (name == "alpha")
    return std::make_unique<NonsmoothAlpha>(system, dt, 0.8);
  if (name == "laursen_love")
    return std::make_unique<LaursenLove>(system, dt);
  if (name == "moreau_jean")
    return std::make_unique<Theta>(system, dt, 0.5, false);
  if (name.rfind("whole_step ", 0) == 0)
    return std::make_unique<AlphaWholeStep>(system, dt, std::stod(name.substr(11)));
  return std::make_unique<Theta>(system, dt, theta_of(name, cfl), true);
}
} // namespace softgrain::schemes

#endif
