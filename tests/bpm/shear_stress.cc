// SPDX-License-Identifier: LGPL-2.1-or-later
// A wall under a shear stress. With friction it rolls a disk over the floor: disk and wall of masses m and M
// are as heavy as M + 3/8 m. With little friction it slides: the friction is mu times the load. A cell that
// repeats comes to rest with the stress that is asked for, or is sheared for ever beyond its strength.
#include "bpm_scene.h"

#include <softgrain/bpm/dynamics.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/numbers.h>

#include <iostream>

using namespace softgrain;
using namespace softgrain::bpm;

namespace
{
Wall<2> wall_at(const dealii::Point<2> &point,
                const dealii::Tensor<1, 2> &normal,
                const bool pressed,
                const bool sheared,
                const WallDescription<2>::Type type)
{
  Wall<2> wall;
  wall.description.type = type;
  wall.description.point = point;
  wall.description.normal = normal;
  const auto drive =
      std::const_pointer_cast<WallDrive>(make_drive(pressed ? "pressure" : "velocity", "wall"));
  if (sheared)
    drive->shear(Expression("1", {"t"}));
  wall.description.drive = drive;
  wall.free.across.mass = pressed ? 3. : 0.;
  wall.free.along.mass = sheared ? 3. : 0.;
  return wall;
}

Dynamics dynamics(const Primaries &disks, const double friction)
{
  DynamicsSettings settings;
  Scene<2> scene;
  scene.friction = friction;
  scene.materials.resize(1);
  scene.bodies.resize(disks.size());
  scene.walls.resize(4);
  for (WallDescription<2> &wall : scene.walls)
    wall.friction = friction;
  settings.pairs = ContactPairs(scene);
  settings.look_ahead = 0.15;
  settings.solver.tolerance = 1e-9;
  settings.solver.max_sweeps = 20000;
  return Dynamics(disks, std::vector<std::shared_ptr<const Attraction>>(disks.size()),
                  std::vector<bool>(disks.size(), false), settings);
}

/// Energy that is missing or too much since the start of a run.
struct Books
{
  explicit Books(const Dynamics &model) : sum(model.sums().kinetic) {}

  void look(const Dynamics &model, const DynamicsReport &report, const std::vector<Wall<2>> &walls)
  {
    sum += report.wall_work - report.contact_loss - report.damping_loss;
    double kinetic = model.sums().kinetic;
    for (const Wall<2> &wall : walls)
      kinetic += kinetic_energy_of(wall);
    largest = std::max({largest, kinetic, std::abs(sum)});
    off = std::max(off, std::abs(kinetic - sum));
  }
  double error() const { return off / largest; }

  double sum, largest = 0., off = 0.;
};

void roll(const double friction, const double load, const double shear)
{
  Primaries disk;
  disk.position = {{0., 1.}};
  disk.velocity = {{0., 0.}};
  disk.angular_velocity = {0.};
  disk.radius = {1.};
  disk.mass = {2.};
  disk.body = {0};
  const dealii::Tensor<1, 2> up({0., 1.});
  using Type = WallDescription<2>::Type;
  std::vector<Wall<2>> walls = {wall_at({0., 0.}, up, false, false, Type::plane),
                                wall_at({0., 2.}, -up, true, true, Type::plane)};
  Dynamics model = dynamics(disk, friction);
  model.detect(walls);
  Books books(model);
  const double dt = 0.01;
  for (unsigned int i = 0; i < 100; ++i)
  {
    put_pressure(walls[1], load, 1.);
    put_shear(walls[1], shear, 1.);
    walls[1].free.along.damping = 0.;
    books.look(model, model.step(dt, walls, {}), walls);
  }
  const double rolling = shear / (3. + 3. / 8. * 2.), sliding = (shear - friction * load) / 3.;
  std::cout << "wall on a disk, friction " << friction << ": acceleration over that of "
            << (rolling > sliding ? "rolling " : "sliding ")
            << walls[1].slide_speed / std::max(rolling, sliding) << ", energy off by "
            << below(1e-10, books.error()) << std::endl;
}

/// Disks of two sizes on a lattice of squares.
Primaries many()
{
  Primaries disks;
  for (unsigned int i = 0; i < 144; ++i)
  {
    disks.position.push_back({1.7 * (i % 12) + 0.2, 1.7 * (i / 12) + 0.2});
    disks.velocity.push_back({0.3 * std::sin(1. * i), 0.3 * std::cos(7. * i)});
    disks.radius.push_back(0.6 + 0.12 * (i * 7 % 3));
    disks.mass.push_back(dealii::numbers::PI * disks.radius.back() * disks.radius.back());
    disks.body.push_back(i);
  }
  disks.angular_velocity.assign(disks.size(), 0.);
  return disks;
}

void cell(const std::string &what, const double shear)
{
  const Primaries disks = many();
  Dynamics model = dynamics(disks, 0.5);
  const dealii::Tensor<1, 2> x({1., 0.}), y({0., 1.});
  const auto type = WallDescription<2>::Type::periodic;
  std::vector<Wall<2>> walls = {
      wall_at({0., 0.}, y, false, false, type), wall_at({0., 20.4}, -y, true, true, type),
      wall_at({0., 0.}, x, false, false, type), wall_at({20.4, 0.}, -x, true, false, type)};
  model.detect(walls);
  Books books(model);
  double mean[2] = {0., 0.}, width = 0., height = 0.;
  const unsigned int n = 800;
  for (unsigned int i = 0; i < n; ++i)
  {
    width = walls[3].point()[0] - walls[2].point()[0];
    height = walls[1].point()[1] - walls[0].point()[1];
    put_pressure(walls[1], 1., width);
    put_pressure(walls[3], 1., height);
    put_shear(walls[1], i > n / 4 ? shear : 0., width);
    books.look(model, model.step(0.05, walls, {}), walls);
    if (2 * i >= n)
    {
      mean[0] -= 2. / n * (walls[1].book.force * walls[1].tangent()) / width;
      mean[1] -= 2. / n * walls[3].book.force[1] / height;
    }
  }
  const double rate = std::abs(walls[1].slide_speed) / height;
  std::cout << what << ": the cell " << (rate < 1e-3 ? "rests" : "flows") << ", energy off by "
            << below(1e-10, books.error());
  if (rate < 1e-3)
    std::cout << ", shear stress off by " << below(0.02, mean[0] / shear - 1.) << " and "
              << below(0.02, std::abs(mean[1]) / shear - 1.);
  std::cout << std::endl;
}
} // namespace

int main()
{
  roll(0.5, 10., 3.);
  roll(0.1, 10., 10.);
  cell("a shear stress of a tenth of the pressure", 0.1);
  cell("of nine tenths", 0.9);
}
