// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls that fly and meet in space. One falls: momentum and energy to rounding. One turns. Two meet head on:
// how long and with which restitution, against Hertz; obliquely with friction: momentum to rounding at every
// step, and angular momentum. Mirror image, exchanged names and two threads.
#include "moving_balls.h"

#include <softgrain/base/parallel.h>

namespace
{
void fall()
{
  MovingBalls ball(text_of(1, false),
                   {"Loads/Gravity=0.001, -0.002, -0.01", "Bodies/a/Velocity=0.1; 0.2; 0.3"});
  const double before = ball.total_energy();
  ball.run(40., [](const StepReport &) {});
  const dealii::Tensor<1, 3> expected({0.1 + 0.04, 0.2 - 0.08, 0.3 - 0.4});
  std::cout << "falls: velocity off by " << below(1e-13, (ball.velocity(0) - expected).norm())
            << ", momentum " << below(1e-13, ball.model->momentum_error()) << ", energy "
            << below(1e-12, (ball.total_energy() - before) / ball.model->energies().kinetic) << '\n';
}

/// What a ball that nothing touches loses of its spin in 100 s.
struct LostSpin
{
  double at_end = 0.;   ///< share
  double worst = 0.;    ///< share at any time
  double of_theta = 0.; ///< at_end over (theta - 1/2) spin^2 dt time, which theta takes to the first order
};

LostSpin turn(const double theta, const double cfl)
{
  std::ostringstream of_step, of_scheme;
  of_step << "Time/CFL multiple=" << cfl;
  of_scheme << "Time/Theta=" << theta;
  MovingBalls ball(text_of(1, false),
                   {"Bodies/a/Angular velocity=0.03, -0.02, 0.01", of_step.str(), of_scheme.str()});
  const dealii::Tensor<1, 3> spin = ball.spin(0);
  LostSpin lost;
  ball.run(100.,
           [&](const StepReport &)
           {
             lost.at_end = (ball.spin(0) - spin).norm() / spin.norm();
             lost.worst = std::max(lost.worst, lost.at_end);
           });
  lost.of_theta = lost.at_end / ((theta - 0.5) * 0.0014 * 100. * 100. / ball.steps);
  return lost;
}

/// Theta's loss falls with the step. Without it spin comes and goes with the square of the step: a ball
/// swings, as its spin stretches it, and forces are those of the two ends of a step.
void turns()
{
  const MovingBalls ball(text_of(1, false), {"Bodies/a/Angular velocity=0.03, -0.02, 0.01"});
  // Lumped masses turn like a ball that is somewhat larger.
  std::cout << "turns: spin over 2/5 m R^2 "
            << ball.spin(0)[0] / (0.4 * ball.state().bodies[0].nodes.mass.sum() * radius * radius * 0.03)
            << '\n';
  for (const double cfl : {4., 2., 1.})
    std::cout << "turns, steps of " << cfl << " CFL: theta 0.55 loses " << turn(0.55, cfl).of_theta
              << " of the first order, theta 0.5 loses " << turn(0.5, cfl).worst << " of its spin\n";
}

struct Impact
{
  double begin = -1., end = 0., restitution = 0., momentum = 0., turning = 0., energy = 0., iterations = 0.;
  unsigned int cut = 0;
  dealii::Tensor<1, 3> velocity, spin; ///< of the one on the left, afterwards
  std::vector<double> all;             ///< velocities of all, afterwards
};

Impact meet(const std::vector<std::string> &changes, const double until)
{
  MovingBalls balls(text_of(2, false), changes);
  Impact impact;
  const dealii::Tensor<1, 3> momentum = balls.momentum(), turning = balls.angular_momentum();
  const double energy = balls.total_energy(), speed = (balls.velocity(0) - balls.velocity(1)).norm(),
               mass = balls.state().bodies[0].nodes.mass.sum(), kinetic = balls.model->energies().kinetic;
  const double before = balls.velocity(0)[0] - balls.velocity(1)[0];
  double force_before = 0.;
  balls.run(until,
            [&](const StepReport &report)
            {
              double force = 0.;
              for (const SpaceContact &contact : balls.state().contacts)
                force += contact.force.norm();
              if (force > 0. && impact.begin < 0.)
                impact.begin = balls.model->time() - report.dt;
              if (force == 0. && force_before > 0.)
                impact.end = balls.model->time() - report.dt;
              force_before = force;
              impact.momentum =
                  std::max(impact.momentum, (balls.momentum() - momentum).norm() / (mass * speed));
              impact.turning = std::max(impact.turning, (balls.angular_momentum() - turning).norm() /
                                                            (mass * speed * radius));
              impact.energy = std::max(impact.energy, std::abs(balls.total_energy() - energy) / kinetic);
            });
  impact.restitution = (balls.velocity(1)[0] - balls.velocity(0)[0]) / before;
  const unsigned int one = balls.state().bodies[0].center()[0] > balls.state().bodies[1].center()[0];
  impact.velocity = balls.velocity(one);
  impact.spin = balls.spin(one) / (0.4 * mass * radius);
  for (const Body<3> &body : balls.state().bodies)
    impact.all.insert(impact.all.end(), body.nodes.velocity.data(),
                      body.nodes.velocity.data() + body.nodes.velocity.size());
  impact.iterations = static_cast<double>(balls.iterations) / balls.steps;
  impact.cut = balls.attempts - balls.steps;
  return impact;
}

/// Hertz's time of an impact at the relative velocity @p v.
double hertz_time(const double v)
{
  const double mass = 2. / 3. * M_PI * radius * radius * radius, stiffness = 0.5 / (1. - poisson * poisson);
  return 2.87 * std::pow(mass * mass / (0.5 * radius * stiffness * stiffness * v), 0.2);
}

std::vector<std::string> head_on(const double v)
{
  std::ostringstream half;
  half << 0.5 * v;
  return {"Bodies/a/Center=-2.45, 0.11, -0.17", "Bodies/b/Center=2.45, 0.11, -0.17",
          "Bodies/a/Velocity=" + half.str() + "; 0; 0", "Bodies/b/Velocity=-" + half.str() + "; 0; 0"};
}

/// @param up 1, or -1 for the mirror image
std::vector<std::string> oblique(const double up, const bool exchanged = false)
{
  const std::string a = exchanged ? "b" : "a", b = exchanged ? "a" : "b";
  std::ostringstream first, second, speed;
  first << 0.93 * up;
  second << 0.07 * up;
  speed << 0.02 * up;
  return {"Contact/Friction=0.3",
          "Newton/Residual tolerance=1e-8",
          "Bodies/" + a + "/Center=-2.3, 0.6, " + first.str(),
          "Bodies/" + b + "/Center=2.3, -0.6, " + second.str(),
          "Bodies/" + a + "/Velocity=0.05; 0; " + speed.str(),
          "Bodies/" + b + "/Velocity=-0.05; 0; 0",
          "Bodies/" + a + "/Angular velocity=0, 0, 0.01"};
}
/// @param sign of the velocity upwards of the second
double off(const Impact &a, const Impact &b, const double sign)
{
  dealii::Tensor<1, 3> difference = a.velocity - b.velocity;
  difference[2] = a.velocity[2] - sign * b.velocity[2];
  return difference.norm() / a.velocity.norm();
}
} // namespace

int main()
{
  fall();
  turns();
  for (const auto &[v, theta] : {std::pair<double, std::string>(0.1, "0.5"), {0.02, "0.5"}, {0.02, "0.55"}})
  {
    std::vector<std::string> changes = head_on(v);
    changes.push_back("Time/Theta=" + theta);
    const Impact impact = meet(changes, 0.1 / v + 1.2 * hertz_time(v));
    std::cout << "head on at " << v << ", theta " << theta << ": time over Hertz's "
              << (impact.end - impact.begin) / hertz_time(v) << ", restitution " << impact.restitution
              << ", momentum " << below(1e-13, impact.momentum) << ", turning " << below(1e-3, impact.turning)
              << ", energy " << below(3e-3, impact.energy) << ", less than 5 iterations a step, none cut "
              << (impact.iterations < 5. && impact.cut == 0) << '\n';
  }
  const Impact hit = meet(oblique(1.), 45.);
  std::cout << "obliquely: velocity " << hit.velocity << ", spin R " << hit.spin << ", momentum "
            << below(1e-13, hit.momentum) << ", turning " << below(3e-3, hit.turning) << ", energy "
            << below(3e-3, hit.energy) << '\n';
  std::cout << "mirror image with names exchanged off by "
            << below(1e-6, off(hit, meet(oblique(-1., true), 45.), -1.)) << '\n';
  set_n_threads(1);
  std::cout << "other number of threads same " << (meet(oblique(1.), 45.).all == hit.all) << '\n';
}
