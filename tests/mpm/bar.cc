// SPDX-License-Identifier: LGPL-2.1-or-later
// Free bar in its first axial mode: period against 2 L/c, balances, and the observed orders in cell size and
// time step.
#include "scene_of.h"

#include <deal.II/base/numbers.h>

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double length = 1., period = 0.2;

/// Amplitude of the velocity in the first mode.
double modal_velocity(const mpm::MpmModel &model)
{
  const mpm::Body<2> &body = model.bodies()[0];
  double sum = 0., norm = 0.;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    const double shape = std::cos(dealii::numbers::PI / length * body.field.place(i)[0]);
    sum += body.nodes.mass[i] * shape * body.nodes.velocity[2 * i];
    norm += body.nodes.mass[i] * shape * shape;
  }
  return sum / norm;
}

struct Result
{
  double period, energy_error, momentum_error, end_velocity;
};

/// Period from the first and the last zero of the modal velocity.
Result run(const std::vector<std::string> &changes, const double n_periods)
{
  const auto model = shipped_scene("verification/bar_period.prm", changes);
  EnergyWatch energy(*model);
  double v = modal_velocity(*model), t = 0., first = 0., last = 0.;
  int n = 0;
  run_until(*model, n_periods * period,
            [&](const StepReport &)
            {
              energy.look(*model);
              const double next = modal_velocity(*model);
              if (v * next < 0.)
              {
                last = t + (model->time() - t) * v / (v - next);
                if (n++ == 0)
                  first = last;
              }
              v = next;
              t = model->time();
            });
  return {n > 1 ? 2. * (last - first) / (n - 1) : 0., energy.error(), model->momentum_error(), v};
}
} // namespace

int main()
{
  const std::vector<std::pair<std::string, std::string>> laws = {{"neo_hookean", "Neo-Hookean"},
                                                                 {"linear_elastic", "Linear elastic"}};
  for (const auto &[law, section] : laws)
  {
    const std::string constants = "Materials/gel/" + section;
    const Result r = run(
        {"Materials/gel/Law=" + law, constants + "/Young's modulus=1e5", constants + "/Poisson's ratio=0"},
        3.);
    std::cout << law << ": period error " << 100. * (r.period / period - 1.) << " %, energy "
              << below(1e-6, r.energy_error) << ", momentum " << below(1e-12, r.momentum_error) << '\n';
  }
  // The trapezoidal rule makes no error to speak of at this step, so the rest is the mesh.
  for (const std::string shape : {"linear", "bspline"})
  {
    double before = 0.;
    for (const std::string cell : {"0.1", "0.05"})
    {
      const double error =
          run({"Material points/Shape function=" + shape, "Mesh/Cell size=" + cell, "Time/Time step=5e-4"},
              2.)
                  .period /
              period -
          1.;
      std::cout << shape << " h " << cell << ": period error " << 100. * error << " %";
      if (before != 0.)
        std::cout << ", order " << std::log2(before / error);
      std::cout << '\n';
      before = error;
    }
  }
  // Velocity in the middle of a slope of its course, against the same mesh with a fine step.
  const auto at = [](const std::string &theta, const std::string &dt) {
    return run({"Mesh/Cell size=0.1", "Time/Theta=" + theta, "Time/Time step=" + dt}, 0.625).end_velocity;
  };
  const double reference = at("0.5", "5e-5");
  for (const std::string theta : {"0.5", "1"})
  {
    double before = 0.;
    for (const std::string dt : {"2.5e-3", "1.25e-3", "6.25e-4"})
    {
      const double error = std::abs(at(theta, dt) - reference) / 1e-3;
      std::cout << "theta " << theta << " dt " << dt << ": error " << error;
      if (before != 0.)
        std::cout << ", order " << std::log2(before / error);
      std::cout << '\n';
      before = error;
    }
  }
}
