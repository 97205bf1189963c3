// SPDX-License-Identifier: LGPL-2.1-or-later
// Obstacles and rigid disks: a disk in an arc swings with the period of a pendulum, sliding or rolling; one
// that rests on two ends presses on them along its radii; one on a beam turns it about its pivot; a drum that
// turns carries a disk along; a plate that moves is the wall that moves so.
#include "bpm_scene.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/dynamics.h>

#include <iostream>

using namespace softgrain;

namespace
{
const double pi = std::acos(-1.), gravity = 9.81;

Obstacle<2> obstacle(const std::vector<Curve> &pieces, const double friction, const std::string &angle = "0")
{
  Scene<2> scene;
  ObstacleDescription<2> description;
  description.name = "obstacle";
  description.pieces = pieces;
  description.friction = friction;
  for (const std::string formula : {"0", "0", angle.c_str()})
    description.motion.push_back(formula_of_time(formula, "obstacle"));
  scene.obstacles = {description};
  return make_obstacles(scene)[0];
}

/// One disk of radius 0.1 and mass 2 under gravity.
class OneDisk
{
public:
  OneDisk(const double x, const double y, std::vector<Obstacle<2>> list) : obstacles(std::move(list))
  {
    bpm::Primaries disk;
    disk.position = {{x, y}};
    disk.velocity = {{0., 0.}};
    disk.radius = {0.1};
    disk.mass = {2.};
    disk.body = {0};
    disk.angular_velocity = {0.};
    bpm::DynamicsSettings settings;
    settings.contact_range = 0.1;
    dynamics = std::make_unique<bpm::Dynamics>(
        disk, std::vector<std::shared_ptr<const bpm::Attraction>>{nullptr}, std::vector<bool>{}, settings);
    dynamics->set_obstacles(&obstacles);
    dynamics->detect(walls);
  }

  bpm::DynamicsReport step(const double dt)
  {
    for (Obstacle<2> &one : obstacles)
      one.plan(time, dt);
    time += dt;
    return dynamics->step(dt, walls, {{0., -gravity}});
  }

  const std::array<double, 2> &place() const { return dynamics->disks().position[0]; }
  double spin() const { return dynamics->disks().angular_velocity[0]; }

  std::vector<Wall<2>> walls;
  std::vector<Obstacle<2>> obstacles;
  std::unique_ptr<bpm::Dynamics> dynamics;
  double time = 0;
};

/// Period in an arc of radius 0.5 from an angle of 0.1, over that of a pendulum of 0.4.
double period(const double friction)
{
  const double start = 0.1, dt = 5e-5;
  OneDisk disk(0.4 * std::sin(start), -0.4 * std::cos(start),
               {obstacle({Curve::arc({0., 0.}, 0.5, pi, 2. * pi)}, friction)});
  std::vector<double> crossings;
  double before = disk.place()[0];
  while (crossings.size() < 5)
  {
    disk.step(dt);
    const double now = disk.place()[0];
    if (before * now <= 0. && before != now)
      crossings.push_back(disk.time - dt * now / (now - before));
    before = now;
  }
  const double pendulum = 2. * pi * std::sqrt(0.4 / gravity) * (1. + start * start / 16.);
  return 0.5 * (crossings[4] - crossings[0]) / pendulum;
}
} // namespace

int main()
{
  std::cout << "period over that of a pendulum, sliding " << period(0.) << ", rolling " << period(1.)
            << ", expected 1 and " << std::sqrt(1.5) << '\n';

  // Ends at 30 degrees from below, on both sides.
  const double s = 0.1 * std::sin(pi / 6.), c = 0.1 * std::cos(pi / 6.);
  OneDisk on_ends(0., c,
                  {obstacle({Curve::segment({-1., 0.}, {-s, 0.})}, 0.),
                   obstacle({Curve::segment({s, 0.}, {1., -0.3})}, 0.)});
  for (unsigned int i = 0; i < 200; ++i)
    on_ends.step(1e-3);
  std::cout << "on two ends: forces over the weight";
  for (const Obstacle<2> &one : on_ends.obstacles)
    std::cout << ' ' << one.force / (2. * gravity);
  std::cout << ", expected " << 0.5 * std::tan(pi / 6.) << " outwards and 0.5\n";

  OneDisk on_beam(0.7, 0.1, {obstacle({Curve::segment({0., 0.}, {2., 0.})}, 0.)});
  for (unsigned int i = 0; i < 20; ++i)
    on_beam.step(1e-3);
  std::cout << "on a beam: force over the weight " << on_beam.obstacles[0].force / (2. * gravity)
            << ", torque over weight times arm " << on_beam.obstacles[0].torque / (2. * gravity * 0.7)
            << '\n';

  // In a drum that turns by 1 rad/s a disk comes to roll: where they touch both have the velocity of the
  // drum.
  OneDisk in_drum(0., -0.4, {obstacle({Curve::arc({0., 0.}, 0.5, 0., 2. * pi)}, 0.5, "180/pi*t")});
  for (unsigned int i = 0; i < 1000; ++i)
    in_drum.step(1e-3);
  const std::array<double, 2> &x = in_drum.place(), &v = in_drum.dynamics->disks().velocity[0];
  const double along = (x[0] * v[1] - x[1] * v[0]) / std::hypot(x[0], x[1]);
  std::cout << "in a drum: speed of the disk over that of the drum where they touch "
            << (along + in_drum.spin() * 0.1) / 0.5 << '\n';

  // A corner is touched once, from where the two pieces make one.
  OneDisk on_corner(
      0., 0.1, {obstacle({Curve::segment({-1., -1.}, {0., 0.}), Curve::segment({0., 0.}, {1., -1.})}, 0.)});
  on_corner.step(1e-3);
  std::cout << "on a corner: " << on_corner.dynamics->present().rows().size()
            << " contact, force over the weight " << on_corner.obstacles[0].force / (2. * gravity) << '\n';

  // A plate that rises presses a grain of bonded primaries against a wall: what it gives is booked.
  const auto model = bpm_scene(grain_scene(disks({{"0, 0", "0; 0"}}, "10")) + R"(
subsection Walls
  set Names = top
  subsection top
    set Point = 0, 10.5
  end
end
subsection Obstacles
  set Names = plate
  subsection plate
    set Points       = -40, -10.5; 40, -10.5
    set Displacement = 0; 0.02*t
  end
end
)");
  // The grain gives way bond by bond, so its force rises and falls: the mean tells.
  double force = 0.;
  for (unsigned int i = 0; i < 1500; ++i)
  {
    model->advance(1.);
    if (i >= 1000)
      force += model->walls()[0].normal_force / 500.;
  }
  std::cout << "a grain between plate and wall: pressed " << (force > 0.1 ? "yes" : "NO")
            << ", momentum error " << below(1e-11, model->momentum_error()) << '\n';
}
