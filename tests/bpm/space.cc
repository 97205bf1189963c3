// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonded particles in space: what aggregates are like; an aggregate that flies and turns keeps its momenta
// and its energy; a ball that rolls or slides down a plane; the weight of what lies on a floor; two grains
// that hit each other and their mirror image; works and energies of grains that are pressed.
#include "space_scene.h"

#include <iostream>

using namespace softgrain;

namespace
{
dealii::Tensor<1, 3> angular_momentum(const bpm::SpaceModel &model)
{
  const bpm::Balls &balls = model.motion().balls();
  dealii::Tensor<1, 3> sum;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const std::array<double, 3> &x = balls.position[i], &v = balls.velocity[i];
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
      sum[d] += balls.mass[i] * (x[e] * v[f] - x[f] * v[e]);
      if (balls.rotate())
        sum[d] += 0.4 * balls.mass[i] * balls.radius[i] * balls.radius[i] * balls.angular_velocity[i][d];
    }
  }
  return sum;
}

void run(bpm::SpaceModel &model, const double end)
{
  while (model.time() < end - 1e-9)
    model.advance(end - model.time());
}

void aggregates()
{
  const std::string one = grain_scene(balls({{"3, -2, 1"}}, "6"));
  const auto model = space_scene(one), again = space_scene(one),
             other = space_scene(one, {"Primaries/Seed=2"}),
             told = space_scene(one, {"Primaries/Number per body=200"});
  const bpm::Balls &all = model->motion().balls();
  double least = 10., largest = 0., sum = 0., volume = 0., beyond = 0.;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    least = std::min(least, 2. * all.radius[i]);
    largest = std::max(largest, 2. * all.radius[i]);
    sum += 2. * all.radius[i];
    volume += all.mass[i];
    beyond = std::max(beyond,
                      std::hypot(all.position[i][0] - 3., all.position[i][1] + 2., all.position[i][2] - 1.) +
                          all.radius[i] - 6.);
  }
  std::cout << "primaries " << model->n_points() << ", told " << told->n_points() << ", sizes from "
            << (least >= 1.6) << " to " << (largest <= 2.6 && largest > 2.4) << ", mean " << sum / all.size()
            << "\nbeyond the shape " << below(1e-9, std::max(0., beyond)) << ", overlap of diameters "
            << below(1e-9, model->motion().present().penetration() / 2.1) << ", same again "
            << (all.position == again->motion().balls().position) << ", other seed "
            << (all.radius == other->motion().balls().radius) << '\n';
  const Snapshot<3> start = model->snapshot();
  std::cout << "share of the volume that is seen " << volume / start.bodies[0].area << '\n';
  run(*model, 20.);
  const Snapshot<3> end = model->snapshot();
  std::cout << "at rest: centre moved by "
            << below(1e-11, end.bodies[0].center.distance(start.bodies[0].center))
            << ", kinetic over stored energy "
            << below(2e-5, end.energies.kinetic / std::abs(end.energies.elastic)) << ", momentum error "
            << below(1e-11, model->momentum_error()) << '\n';
}

void flight()
{
  const auto model = space_scene(grain_scene(balls({{"0, 0, 0", "1; 2; 0.5", "0.02, 0.03, -0.01"}}, "5")),
                                 {"Contact/Friction=0.3"});
  const dealii::Tensor<1, 3> before = angular_momentum(*model);
  const Energies start = model->energies();
  run(*model, 20.);
  std::cout << "flight: momentum error " << below(1e-12, model->momentum_error()) << ", angular momentum "
            << below(1e-11, (angular_momentum(*model) - before).norm() / before.norm()) << ", energy "
            << below(1e-3, energy_error(start, model->energies())) << '\n';
}

/// A single primary on a floor under a gravity that is oblique by @p slope to it.
void incline(const double friction)
{
  const double slope = 0.6, along = 0.01 * slope, across = 0.01;
  std::ostringstream gravity;
  gravity << "Loads/Gravity=" << 0.8 * along << ", " << 0.6 * along << ", " << -across;
  const auto model = space_scene(
      grain_scene(balls({{"0, 0, 1.0000001"}}, "1") +
                  "subsection Walls\n  set Names = bottom\n  subsection bottom\n  "
                  "  set Point = 0, 0, 0\n  end\nend\n"),
      {"Contact/Friction=" + std::to_string(friction), "Contact/Friction at walls=same", gravity.str(),
       "Primaries/Number per body=1", "Primaries/Smallest diameter=2", "Primaries/Largest diameter=2"});
  run(*model, 10.);
  const auto &v = model->motion().balls().velocity[0], &spin = model->motion().balls().angular_velocity[0];
  const bool rolls = friction > 2. / 7. * slope;
  const double right = 10. * (rolls ? 5. / 7. * along : along - friction * across);
  std::cout << (rolls ? "rolling" : "sliding") << ": velocity off by "
            << below(1e-9, std::hypot(v[0], v[1]) / right - 1.) << ", spin by "
            << below(1e-9,
                     std::hypot(spin[0], spin[1]) / (rolls ? right : 2.5 * friction * across * 10.) - 1.)
            << ", side " << below(1e-9, (v[0] * 0.6 - v[1] * 0.8) / right) << '\n';
}

void weight()
{
  const auto model =
      space_scene(grain_scene(balls({{"5, 5, 4.3"}}, "4.2") + box("10", "0")),
                  {"Loads/Gravity=0, 0, -1e-3", "Contact/Friction=0.5", "Contact/Friction at walls=same",
                   "Contact/Wall tolerance=1e-4", "Contact/Tolerance=1e-6"});
  double given = 0., mass = 0., start = 0.;
  for (const double one : model->motion().balls().mass)
    mass += one;
  run(*model, 1000.);
  for (start = model->time(); model->time() < 1400.;)
    given += model->advance(1.).dt * model->walls()[4].normal_force;
  std::cout << "floor and weight differ by "
            << below(1e-3, given / (model->time() - start) / (1e-3 * mass) - 1.) << ", momentum error "
            << below(1e-10, model->momentum_error()) << '\n';
}

/// Velocities of two grains after they have met, and what they lost.
std::vector<double> collision(const double mirror, const Changes &changes)
{
  const std::string x = mirror > 0. ? "" : "-";
  const auto model =
      space_scene(grain_scene(balls({{"0, 0, 0", x + "0.4; 0; 0"},
                                     {x + "9, 2, 1", (mirror > 0. ? "-" : "") + std::string("0.4; 0; 0")}},
                                    "4.2")),
                  changes);
  // The images of primaries are not made by the model: both grains are balls of one primary each.
  const Energies start = model->energies();
  const dealii::Tensor<1, 3> before = angular_momentum(*model);
  run(*model, 8.);
  std::vector<double> result;
  for (const BodyState<3> &body : model->snapshot().bodies)
    result.insert(result.end(), {mirror * body.velocity[0], body.velocity[1], body.velocity[2]});
  const double turned = (angular_momentum(*model) - before).norm() / before.norm();
  result.insert(result.end(), {model->momentum_error(), turned, energy_error(start, model->energies()),
                               model->energies().dissipated / start.kinetic});
  return result;
}

void collisions()
{
  const Changes single = {"Contact/Friction=0.4", "Primaries/Number per body=1",
                          "Primaries/Smallest diameter=8.4", "Primaries/Largest diameter=8.4",
                          "Time/Time step=0.02"};
  const std::vector<double> one = collision(1., single), image = collision(-1., single),
                            many = collision(1., {"Contact/Friction=0.4"});
  double differs = 0.;
  for (unsigned int k = 0; k < 6; ++k)
    differs = std::max(differs, std::abs(one[k] - image[k]));
  std::cout << "collision: mirror " << below(1e-12, differs) << ", momentum " << below(1e-12, one[6])
            << ", angular momentum " << below(1e-12, one[7]) << ", lost " << one[9] << "\ngrains: momentum "
            << below(1e-11, many[6]) << ", angular momentum " << below(1e-11, many[7]) << ", energy error "
            << below(1e-2, many[8]) << '\n';
}

void pressed()
{
  const auto model = space_scene(grain_scene(balls({{"5, 5, 5"}}, "4.9") + box("10", "0.05")));
  const Energies start = model->energies();
  double top = 0., bottom = 0.;
  while (model->time() < 80.)
  {
    const double dt = model->advance(1.).dt;
    top += dt * model->walls()[5].normal_force;
    bottom += dt * model->walls()[4].normal_force;
  }
  double work = 0.;
  for (const auto &[name, value] : model->works())
    work += value;
  std::cout << "pressed: forces of bottom and top differ by " << below(0.01, bottom / top - 1.)
            << ", above 0 " << (top > 0.) << ", energy error "
            << below(0.02, energy_error(start, model->energies())) << ", work beside walls "
            << below(1e-12, work / model->energies().external_work - 1.) << ", overlap "
            << below(0.02, model->motion().present().penetration() / 2.1) << ", volume over that at rest "
            << model->snapshot().bodies[0].area / model->snapshot().bodies[0].reference_area << '\n';
}

void refused(const std::string &more, const std::vector<std::string> &changes)
{
  try
  {
    space_scene(grain_scene(balls({{"5, 5, 5"}}, "4.9") + box("10", "0.05") + more), changes);
    std::cout << "NOT refused\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}

void refusals()
{
  for (const char *const change : {"Contact/Rolling resistance=0.1", "Primaries/Strength=1 + r",
                                   "Walls/left/Drive=pressure", "Primaries/Library=a.csv"})
    refused("", {change});
  refused("subsection Obstacles\n  set Names = plate\n  subsection plate\n    set Points = 0, -9; 1, -9\n"
          "    set Thickness = 0.1\n  end\nend\n",
          {});
}
} // namespace

int main()
{
  aggregates();
  flight();
  incline(0.5);
  incline(0.1);
  weight();
  collisions();
  pressed();
  refusals();
}
