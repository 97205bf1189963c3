// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_friction_h
#define softgrain_tests_mpm_contact_schemes_friction_h

// A block of mass 1 on a plane, pressed with 1 / friction, so that friction is at most 1; it may hang on a
// spring. Every scheme stands with the same normal impulse, so what differs is what it asks of sliding.
#include "schemes.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::schemes
{
/// Where friction asks for no sliding: of the move of the step, or of the velocity at its end.
class SlidingBlock
{
public:
  SlidingBlock(const std::string &scheme, const double spring, const double dt)
      : scheme(scheme), spring(spring), dt(dt)
  {
    if (scheme.rfind("softgrain", 0) == 0)
      theta = theta_of(scheme, 1.);
  }

  /// From @p x0 with @p v0; @p friction is the force at the start.
  void start(const double x0, const double v0, const double friction)
  {
    x = x0;
    v = v0;
    smooth = -spring * x;
    // Impulses of contact are no part of the accelerations of the nonsmooth scheme.
    a = smooth + (scheme == "newmark" ? friction : 0.);
  }

  void step()
  {
    if (scheme == "newmark")
      newmark();
    else if (scheme == "alpha")
      alpha();
    else
      theta_step();
  }

  double x = 0., v = 0.;

private:
  /// Friction impulse that brings @p velocity to 0 if it can, with @p response to a unit of impulse.
  double friction(const double velocity, const double response) const
  {
    return std::clamp(-velocity / response, -dt, dt);
  }

  void theta_step()
  {
    const bool moves = scheme == "kane" || scheme == "laursen_love";
    const double x_free = x + (1. - theta) * dt * v, A = 1. + theta * theta * dt * dt * spring,
                 free = (v - dt * spring * ((1. - theta) * x + theta * x_free)) / A,
                 asked = moves ? (1. - theta) * v + theta * free : free;
    const double v_new = free + friction(asked, (moves ? theta : 1.) / A) / A;
    x += dt * ((1. - theta) * v + theta * v_new);
    v = v_new;
  }

  void newmark()
  {
    const double beta = 0.25 * dt * dt, x_star = x + dt * v + beta * a, A = 1. + beta * spring,
                 free = v + 0.5 * dt * (a - spring * x_star / A);
    const double P = friction(free, 0.5 / A); // dt times the friction at the end
    const double a_new = (P / dt - spring * x_star) / A;
    x = x_star + beta * a_new;
    v += 0.5 * dt * (a + a_new);
    a = a_new;
  }

  void alpha()
  {
    const double radius = 0.8, alpha_m = (2. * radius - 1.) / (radius + 1.), alpha_f = radius / (radius + 1.),
                 gamma = 0.5 + alpha_f - alpha_m, beta = 0.25 * (gamma + 0.5) * (gamma + 0.5),
                 share = (1. - alpha_f) / (1. - alpha_m);
    const double known = (alpha_f * smooth - alpha_m * a) / (1. - alpha_m);
    const double x_star = x + dt * v + (0.5 - beta) * dt * dt * a + beta * dt * dt * known;
    x = x_star / (1. + beta * dt * dt * share * spring);
    smooth = -spring * x;
    const double a_new = share * smooth + known, v_smooth = v + dt * ((1. - gamma) * a + gamma * a_new);
    a = a_new;
    v = v_smooth + friction(v_smooth, 1.);
  }

  const std::string scheme;
  const double spring, dt;
  double theta = 0.5, a = 0., smooth = 0.;
};

struct Slide
{
  double place;   ///< error of where it stays, over the way or the first amplitude
  double chatter; ///< largest velocity in the steps after it should stand, over the first or largest one
  double creep;   ///< way in these steps, over the way or amplitude
};

/// Decelerates from the speed 1 with 1 and stands at 1/2. @p phase: part of a step in which it stops
inline Slide decelerating_block(const std::string &scheme, const double steps, const double phase)
{
  const double dt = 1. / (std::floor(steps) + phase);
  SlidingBlock block(scheme, 0., dt);
  block.start(0., 1., -1.);
  const unsigned int stop = std::ceil(1. / dt - 1e-9) + 2;
  for (unsigned int n = 0; n < stop; ++n)
    block.step();
  const double there = block.x;
  Slide slide{block.x / 0.5 - 1., 0., 0.};
  for (unsigned int n = 0; n < 100; ++n)
  {
    block.step();
    slide.chatter = std::max(slide.chatter, std::abs(block.v));
  }
  slide.creep = (block.x - there) / 0.5;
  return slide;
}

/// The worst over the parts of a step in which the block may stop.
inline Slide worst_decelerating_block(const std::string &scheme, const double steps)
{
  Slide worst{0., 0., 0.};
  for (const double phase : {0.1, 0.3, 0.5, 0.7, 0.9})
  {
    const Slide one = decelerating_block(scheme, steps, phase);
    worst.place = std::max(worst.place, std::abs(one.place));
    worst.chatter = std::max(worst.chatter, one.chatter);
    worst.creep = std::max(worst.creep, std::abs(one.creep));
  }
  return worst;
}

/// On a spring of 1 from rest at 5.3: turns at -3.3 and 1.3 and sticks at 0.7, after three half periods.
inline Slide oscillating_block(const std::string &scheme, const double steps_per_period)
{
  const double period = 2. * M_PI, dt = period / steps_per_period;
  SlidingBlock block(scheme, 1., dt);
  block.start(5.3, 0., 1.);
  double t = 0.;
  for (; t < 2.5 * period; t += dt)
    block.step();
  const double there = block.x;
  Slide slide{(block.x - 0.7) / 5.3, 0., 0.};
  for (unsigned int n = 0; n < 100; ++n)
  {
    block.step();
    slide.chatter = std::max(slide.chatter, std::abs(block.v) / 4.3);
  }
  slide.creep = (block.x - there) / 5.3;
  return slide;
}
} // namespace softgrain::schemes

#endif
