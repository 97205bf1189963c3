// SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit steps in space. One ball falls, to rounding. Two hit each other obliquely with friction: momentum
// to rounding; energy by what falls with the step; velocities are those of implicit steps of the same length
// that damp nothing; mirror image with names exchanged; threads. One bounces off a belt, which feels what the
// ball gets. Steps that are too long, and cells that repeat, are refused.
#include "moving_balls.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>

#include <algorithm>

namespace
{
using Changes = std::vector<std::string>;

void fall()
{
  MovingBalls ball(text_of(1, false), {"Time/Scheme=explicit", "Loads/Gravity=0.001, -0.002, -0.01",
                                       "Bodies/a/Velocity=0.1; 0.2; 0.3"});
  const double before = ball.total_energy();
  ball.run(40., [](const StepReport &) {});
  const dealii::Tensor<1, 3> expected({0.1 + 0.04, 0.2 - 0.08, 0.3 - 0.4});
  std::cout << "falls: velocity off by " << below(1e-12, (ball.velocity(0) - expected).norm())
            << ", momentum " << below(1e-12, ball.model->momentum_error()) << ", energy "
            << below(1e-12, (ball.total_energy() - before) / ball.model->energies().kinetic) << '\n';
}

struct Hit
{
  double momentum = 0., turning = 0., energy = 0.;
  double told = 0.;        ///< by how much contacts tell another impulse than a ball gets, over that
  std::vector<double> all; ///< velocities, afterwards
  std::array<dealii::Tensor<1, 3>, 2> velocity, spin;
};

/// @param up 1, or -1 for the mirror image with names exchanged
Hit hit(const double up, const Changes &more)
{
  const std::string a = up > 0. ? "a" : "b", b = up > 0. ? "b" : "a";
  std::ostringstream first, second, speed;
  first << 0.93 * up;
  second << 0.07 * up;
  speed << 0.02 * up;
  Changes changes = {"Contact/Friction=0.3",
                     "Bodies/" + a + "/Center=-2.3, 0.6, " + first.str(),
                     "Bodies/" + b + "/Center=2.3, -0.6, " + second.str(),
                     "Bodies/" + a + "/Velocity=0.05; 0; " + speed.str(),
                     "Bodies/" + b + "/Velocity=-0.05; 0; 0",
                     "Bodies/" + a + "/Angular velocity=0, 0, 0.01"};
  changes.insert(changes.end(), more.begin(), more.end());
  MovingBalls balls(text_of(2, false), changes);
  Hit found;
  const dealii::Tensor<1, 3> momentum = balls.momentum(), turning = balls.angular_momentum();
  const double energy = balls.total_energy(), kinetic = balls.model->energies().kinetic,
               mass = balls.state().bodies[0].nodes.mass.sum();
  dealii::Tensor<1, 3> told = balls.state().bodies[0].nodes.momentum();
  const dealii::Tensor<1, 3> began = told;
  balls.run(45.,
            [&](const StepReport &report)
            {
              for (const SpaceContact &contact : balls.state().contacts)
                told += (contact.body == 0 ? 1. : -1.) * report.dt * contact.force;
              found.momentum = std::max(found.momentum, (balls.momentum() - momentum).norm() / mass / 0.1);
              found.turning =
                  std::max(found.turning, (balls.angular_momentum() - turning).norm() / mass / 0.1 / radius);
              found.energy = std::max(found.energy, std::abs(balls.total_energy() - energy) / kinetic);
            });
  const dealii::Tensor<1, 3> ends = balls.state().bodies[0].nodes.momentum();
  found.told = (told - ends).norm() / (ends - began).norm();
  for (unsigned int k = 0; k < 2; ++k)
  {
    const unsigned int body = up > 0. ? k : 1 - k;
    found.velocity[k] = balls.velocity(body);
    found.spin[k] = balls.spin(body) / (0.4 * mass * radius);
  }
  for (const Body<3> &body : balls.state().bodies)
    found.all.insert(found.all.end(), body.nodes.velocity.data(),
                     body.nodes.velocity.data() + body.nodes.velocity.size());
  return found;
}

/// Velocities and spins of two runs, over the speed of the hit. @param up as in hit(), of the second
double off(const Hit &one, const Hit &other, const double up)
{
  double most = 0.;
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double mirrored = d == 2 ? up : 1.;
      most = std::max({most, std::abs(one.velocity[k][d] - mirrored * other.velocity[k][d]) / 0.1,
                       std::abs(one.spin[k][d] - up * mirrored * other.spin[k][d]) / 0.1});
    }
  return most;
}

void on_a_belt()
{
  MovingBalls ball(text_of(1, true), {"Time/Scheme=explicit", "Bodies/a/Center=0.1, -0.07, 2.45",
                                      "Bodies/a/Velocity=0; 0; -0.05", "Walls/bottom/Friction=0.3",
                                      "Walls/bottom/Tangential velocity=0.02"});
  const Body<3> &body = ball.state().bodies[0];
  const double mass = body.nodes.mass.sum(), before = ball.total_energy(),
               kinetic = ball.model->energies().kinetic;
  dealii::Tensor<1, 3> given;
  ball.run(30.,
           [&](const StepReport &report)
           {
             for (const SpaceContact &contact : ball.state().contacts)
               given += report.dt * contact.force;
           });
  const dealii::Tensor<1, 3> gained = ball.momentum() - dealii::Tensor<1, 3>({0., 0., -0.05 * mass});
  std::cout << "off a belt: what it gives is " << below(1e-12, (given - gained).norm() / gained.norm())
            << " from what the ball gets, friction over normal impulse " << gained[0] / gained[2]
            << ", aside " << below(0.02, gained[1] / gained[0]) << ", energy "
            << below(5e-3, (ball.total_energy() - before) / kinetic) << '\n';
}
} // namespace

int main()
{
  fall();
  const Changes steps = {"Time/Scheme=explicit", "Time/CFL multiple=0.4"};
  const Hit found = hit(1., steps), fine = hit(1., {"Time/Scheme=explicit", "Time/CFL multiple=0.2"}),
            implicit = hit(1., {"Time/Theta=0.5", "Time/CFL multiple=0.4"});
  std::cout << "obliquely: velocity " << found.velocity[0] << ", spin R " << found.spin[0] << "\n  momentum "
            << below(1e-12, found.momentum) << ", what contacts tell " << below(1e-12, found.told)
            << ", turning " << below(3e-3, found.turning) << ", energy " << below(0.03, found.energy)
            << ", with half the step less than .6 of that " << (fine.energy < 0.6 * found.energy) << '\n'
            << "  implicit steps off by " << below(0.02, off(found, implicit, 1.)) << '\n'
            << "  mirror image with names exchanged off by " << below(1e-7, off(found, hit(-1., steps), -1.))
            << '\n';
  set_n_threads(2);
  std::cout << "  two threads same " << (hit(1., steps).all == found.all) << '\n';
  set_n_threads(1);
  on_a_belt();
  for (const Changes &wrong :
       {Changes{"Time/Scheme=explicit", "Bodies/a/Center=0, 0, 2.45", "Time/Time step=5"},
        Changes{"Time/Scheme=explicit", "Bodies/a/Center=0, 0, 5", "Walls/Names=bottom, top",
                "Walls/bottom/Type=periodic", "Walls/top/Type=periodic", "Walls/top/Point=0, 0, 10"}})
    try
    {
      MovingBalls refused(text_of(1, true), wrong);
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
