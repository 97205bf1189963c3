// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads that see the velocity, on bodies that nothing touches. Drag c towards a medium of velocity w: v = w +
// (v0 - w) exp(-c t). In a frame that turns with Ω a body goes straight ahead as seen from outside, and
// turns by -Ω when it does not turn there; Coriolis forces do no work. Errors fall with the square of the
// step. In explicit steps drag alone is exact, but ways are of first order. The books know all of it.
#include "moving_balls.h"

#include <cmath>
#include <iomanip>

namespace
{
constexpr double rate = 3., omega = 2., end_time = 0.5;
const dealii::Tensor<1, 2> first_velocity({0.3, -0.2}), medium({0.1, 0.4});
const dealii::Point<2> first_place(0.2, 0.1);

const std::string drag = "Loads/Drag/Rate=3", wind = "Loads/Drag/Velocity=0.1; 0.4",
                  turns = "Loads/Rotating frame/Angular velocity=2",
                  about = "Loads/Rotating frame/Center=0.05, -0.1";

std::unique_ptr<mpm::MpmModel> disk(std::vector<std::string> changes, const double dt)
{
  std::ostringstream step;
  step << "Time/Time step=" << dt;
  changes.push_back(step.str());
  return scene_of_text(gel("0.3", "1e4", "1000") + R"(
subsection Mesh
  set Lower     = -1, -1
  set Upper     = 1, 1
  set Cell size = 0.02
end
subsection Bodies
  set Names = disk
  subsection disk
    set Radius   = 0.05
    set Center   = 0.2, 0.1
    set Velocity = 0.3; -0.2
  end
end
subsection Stop
  set End time = 0.5
end
)",
                       changes);
}

dealii::Tensor<1, 2> velocity(const mpm::MpmModel &model)
{
  return model.bodies()[0].nodes.momentum() / model.bodies()[0].nodes.mass.sum();
}

double work_of(const std::vector<std::pair<std::string, double>> &works, const std::string &name)
{
  for (const auto &[column, work] : works)
    if (column.rfind(name + "_work", 0) == 0)
      return work;
  return std::nan("");
}

struct Errors
{
  double way = 0., speed = 0., work = 0., momentum = 0., energy = 0., iterations = 0.;
};

/// What @p expected says of place and velocity at the end, and the work of the load.
Errors errors(mpm::MpmModel &model,
              const std::string &load,
              const dealii::Point<2> &place,
              const dealii::Tensor<1, 2> &speed,
              const double work_per_mass)
{
  Errors e;
  EnergyWatch watch(model);
  unsigned int iterations = 0, steps = 0;
  run_until(model, end_time,
            [&](const StepReport &report)
            {
              iterations += report.newton_iterations;
              ++steps;
              watch.look(model);
            });
  const double mass = model.bodies()[0].nodes.mass.sum();
  e.way = (model.bodies()[0].center() - place).norm();
  e.speed = (velocity(model) - speed).norm();
  e.work = work_of(model.works(), load) / mass - work_per_mass;
  e.momentum = model.momentum_error();
  e.energy = watch.error();
  e.iterations = double(iterations) / steps;
  return e;
}

double or_zero(const double value)
{
  return std::abs(value) < 1e-12 ? 0. : value;
}

void show(const std::string &what, const Errors &coarse, const Errors &fine)
{
  std::cout << what << ": way off by " << fine.way << " m, that of twice the step over it "
            << coarse.way / fine.way << ", velocity " << or_zero(fine.speed) << " m/s, work "
            << or_zero(fine.work) << " J/kg, momentum " << below(1e-9, fine.momentum) << ", energy "
            << below(1e-8, fine.energy) << ", iterations " << fine.iterations << '\n';
}

Errors dragged(const std::string &scheme, const double dt)
{
  const auto model = disk({drag, wind, "Time/Scheme=" + scheme,
                           "Time/Theta=" + std::string(scheme == "moreau_jean" ? "0.5" : "0")},
                          dt);
  const double left = std::exp(-rate * end_time);
  const dealii::Tensor<1, 2> beside = first_velocity - medium, end = medium + left * beside;
  const dealii::Point<2> place = first_place + end_time * medium + (1. - left) / rate * beside;
  return errors(*model, "drag", place, end, 0.5 * (end.norm_square() - first_velocity.norm_square()));
}

dealii::Tensor<1, 2> turned(const dealii::Tensor<1, 2> &v, const double angle)
{
  return dealii::Tensor<1, 2>(
      {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1]});
}

/// A body that does not turn as seen from outside.
Errors in_frame(const std::string &scheme, const double dt)
{
  const auto model = disk({turns, about, "Time/Scheme=" + scheme, "Bodies/disk/Angular velocity=-2",
                           "Time/Theta=" + std::string(scheme == "moreau_jean" ? "0.5" : "0"),
                           "Newton/Displacement tolerance=1e-9", "Newton/Residual tolerance=1e-10",
                           "Newton/Energy tolerance=1e-18"},
                          dt);
  const dealii::Point<2> center(0.05, -0.1);
  const dealii::Tensor<1, 2> arm = first_place - center,
                             outside = first_velocity + omega * dealii::Tensor<1, 2>({-arm[1], arm[0]}),
                             end = turned(arm + end_time * outside, -omega * end_time),
                             speed = turned(outside, -omega * end_time) -
                                     omega * dealii::Tensor<1, 2>({-end[1], end[0]});
  return errors(*model, "rotating_frame", center + end, speed,
                0.5 * omega * omega * (end.norm_square() - arm.norm_square()));
}

/// By how much the velocity of a ball is off at the end that drag slows in space.
double dragged_in_space(const std::string &dt)
{
  MovingBalls ball(text_of(1, false),
                   {"Loads/Drag/Rate=0.1", "Loads/Drag/Velocity=0; 0.2; 0", "Bodies/a/Velocity=0.1; 0; 0.3",
                    "Time/Theta=0.5", "Time/Time step=" + dt});
  const double before = ball.total_energy(), mass = ball.state().bodies[0].nodes.mass.sum();
  ball.run(10., [](const StepReport &) {});
  const double left = std::exp(-1.);
  const dealii::Tensor<1, 3> expected({0.1 * left, 0.2 * (1. - left), 0.3 * left});
  std::cout << "drag in space: work "
            << work_of(ball.model->works(), "drag") / mass - 0.5 * (expected.norm_square() - 0.1)
            << ", momentum " << below(1e-12, ball.model->momentum_error()) << ", energy "
            << below(1e-10, (ball.total_energy() - before) / ball.model->energies().kinetic) << '\n';
  return (ball.velocity(0) - expected).norm();
}

/// The same in a frame that turns; from outside a ball at (2, 0, 0) has the velocity (0.3, 0.2, 0.1).
double in_frame_in_space(const std::string &dt)
{
  MovingBalls frame(text_of(1, false),
                    {"Loads/Rotating frame/Angular velocity=0, 0, 0.1", "Bodies/a/Velocity=0.3; 0; 0.1",
                     "Bodies/a/Angular velocity=0, 0, -0.1", "Bodies/a/Center=2, 0, 0", "Time/Theta=0.5",
                     "Time/Time step=" + dt});
  frame.run(10., [](const StepReport &) {});
  const dealii::Tensor<1, 2> end = turned(dealii::Tensor<1, 2>({2. + 3., 2.}), -1.),
                             speed = turned(dealii::Tensor<1, 2>({0.3, 0.2}), -1.) -
                                     0.1 * dealii::Tensor<1, 2>({-end[1], end[0]});
  std::cout << "a frame that turns in space: momentum " << below(1e-12, frame.model->momentum_error())
            << '\n';
  return (frame.velocity(0) - dealii::Tensor<1, 3>({speed[0], speed[1], 0.1})).norm();
}

void in_space(double (*const error_of)(const std::string &))
{
  const double coarse = error_of("1"), fine = error_of("0.5");
  std::cout << "velocity off by " << fine << ", that of twice the step over it " << coarse / fine << '\n';
}
} // namespace

int main()
{
  std::cout << std::setprecision(2);
  for (const std::string scheme : {"moreau_jean", "newmark"})
  {
    show("drag, " + scheme, dragged(scheme, 0.02), dragged(scheme, 0.01));
    show("a frame that turns, " + scheme, in_frame(scheme, 0.02), in_frame(scheme, 0.01));
  }
  show("drag, explicit", dragged("explicit", 4e-4), dragged("explicit", 2e-4));
  show("a frame that turns, explicit", in_frame("explicit", 4e-4), in_frame("explicit", 2e-4));
  in_space(dragged_in_space);
  in_space(in_frame_in_space);
}
