// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid disks in a cell that repeats. Two that meet across its edges are two in its middle. Many are
// compacted by sides of prescribed velocity or under pressure, and sheared by a lattice that slides: momentum
// is kept, the energy balances to rounding, the stress through the sides is symmetric, and at rest it is the
// pressure.
#include "bpm_scene.h"

#include <softgrain/bpm/dynamics.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/numbers.h>

#include <iostream>

using namespace softgrain;
using namespace softgrain::bpm;

namespace
{
Wall<2> side(const dealii::Point<2> &point,
             const dealii::Tensor<1, 2> &normal,
             const double speed,
             const double pressure)
{
  Wall<2> wall;
  wall.description.type = WallDescription<2>::Type::periodic;
  wall.description.point = point;
  wall.description.normal = normal;
  wall.description.drive = make_drive(pressure > 0. ? "pressure" : "velocity", "side");
  wall.speed = speed;
  wall.free.across.mass = pressure > 0. ? 3. : 0.;
  return wall;
}

/// Bottom, top, left and right; top and right close on the cell, with a speed or under a pressure.
std::vector<Wall<2>> sides(const double width, const double height, const double speed, const double pressure)
{
  const dealii::Tensor<1, 2> x({1., 0.}), y({0., 1.});
  return {side({0., 0.}, y, 0., 0.), side({0., height}, -y, speed, pressure), side({0., 0.}, x, 0., 0.),
          side({width, 0.}, -x, speed, pressure)};
}

Dynamics dynamics(const Primaries &disks, const double friction)
{
  DynamicsSettings settings;
  Scene<2> scene;
  scene.friction = friction;
  scene.materials.resize(1);
  scene.bodies.resize(disks.size());
  settings.pairs = ContactPairs(scene);
  settings.look_ahead = 0.15;
  settings.solver.tolerance = 1e-8;
  settings.solver.max_sweeps = 20000;
  return Dynamics(disks, std::vector<std::shared_ptr<const Attraction>>(disks.size()),
                  std::vector<bool>(disks.size(), false), settings);
}

void across_edges(const double friction)
{
  Primaries disks;
  disks.velocity = {{0.5, 0.}, {-0.3, 0.1}};
  disks.radius = {8., 8.};
  disks.mass = {201., 201.};
  disks.body = {0, 1};
  if (friction > 0.)
    disks.angular_velocity = {0.01, 0.02};
  Primaries shifted = disks;
  disks.position = {{15., 25.}, {33., 28.}};
  shifted.position = {{45., 50.}, {3., 3.}}; // the second one a cell to the left and one down
  Dynamics middle = dynamics(disks, friction), edge = dynamics(shifted, friction);
  std::vector<Wall<2>> of_middle = sides(60., 50., 0., 0.), of_edge = of_middle;
  middle.detect(of_middle);
  edge.detect(of_edge);
  double apart = 0.;
  bool contact = false;
  for (unsigned int i = 0; i < 80; ++i)
  {
    middle.step(0.05, of_middle, {});
    edge.step(0.05, of_edge, {});
    for (const double impulse : edge.present().rows().impulse)
      contact = contact || impulse > 0.;
    for (unsigned int b = 0; b < 2; ++b)
      for (unsigned int d = 0; d < 2; ++d)
        apart = std::max(apart, std::abs(middle.disks().velocity[b][d] - edge.disks().velocity[b][d]));
  }
  std::cout << "two disks, friction " << friction << ": contact " << (contact ? "yes" : "no")
            << ", middle and edges differ by " << below(1e-11, apart) << '\n';
}

/// Disks of two sizes on a lattice of squares, each with a velocity of its own.
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
  return disks;
}

dealii::Tensor<1, 2> momentum(const Primaries &disks)
{
  dealii::Tensor<1, 2> sum;
  for (std::size_t i = 0; i < disks.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      sum[d] += disks.mass[i] * disks.velocity[i][d];
  return sum;
}

void deform(const std::string &what,
            const double friction,
            const double speed,
            const double pressure,
            const double slide,
            const unsigned int n)
{
  Primaries start = many();
  if (friction > 0.)
    start.angular_velocity.assign(start.size(), 0.);
  Dynamics model = dynamics(start, friction);
  std::vector<Wall<2>> walls = sides(20.4, 20.4, speed, pressure);
  model.detect(walls);
  const double dt = 0.05, at_start = model.sums().kinetic;
  dealii::Tensor<1, 2> given = momentum(start);
  double books = at_start, off = 0., largest = at_start, stress[4] = {0., 0., 0., 0.}, width = 0.,
         height = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    width = walls[3].point()[0] - walls[2].point()[0];
    height = walls[1].point()[1] - walls[0].point()[1];
    if (pressure > 0.)
    {
      put_pressure(walls[1], pressure, width);
      put_pressure(walls[3], pressure, height);
    }
    walls[1].slide_speed = slide;
    const DynamicsReport report = model.step(dt, walls, {});
    books += report.wall_work - report.contact_loss - report.damping_loss;
    given += report.cell_impulse;
    double kinetic = model.sums().kinetic;
    for (const Wall<2> &wall : walls)
      kinetic += kinetic_energy_of(wall);
    off = std::max(off, std::abs(kinetic - books));
    largest = std::max(largest, kinetic);
    if (2 * i >= n)
    {
      const double now[4] = {walls[3].book.force[0] / height, walls[1].book.force[1] / width,
                             walls[1].book.force[0] / width, walls[3].book.force[1] / height};
      for (unsigned int k = 0; k < 4; ++k)
        stress[k] += 2. * now[k] / n;
    }
  }
  double area = 0.;
  for (const double r : start.radius)
    area += dealii::numbers::PI * r * r;
  std::cout << what << ": packing fraction " << area / (width * height) << ", the cell above "
            << (walls[1].offset * slide < 0. ? "goes with the top" : "stands above") << ", momentum off by "
            << below(1e-10, (momentum(model.disks()) - given).norm()) << ", energy by "
            << below(1e-10, off / largest) << ", asymmetry "
            << below(1e-3, (stress[2] - stress[3]) / stress[1]);
  if (pressure > 0.)
    std::cout << ", stress off by " << below(0.03, stress[0] / pressure - 1.) << " and "
              << below(0.03, stress[1] / pressure - 1.);
  if (slide != 0.)
    std::cout << ", shear stress " << (stress[2] * slide > 0. ? "resists" : "DRIVES");
  std::cout << '\n';
}
} // namespace

int main()
{
  across_edges(0.);
  across_edges(0.5);
  deform("compaction", 0., 0.2, 0., 0., 150);
  deform("pressure", 0., 0., 1., 0., 600);
  deform("simple shear", 0., 0., 1., -0.4, 400);
  deform("simple shear, friction", 0.5, 0., 1., -0.4, 400);
}
