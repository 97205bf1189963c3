// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls without a model: where a formula takes them, the length that a pressure acts on while its neighbours
// move, forces and impulses that they book, balance of momentum, and who touches whom.
#include <softgrain/analysis/touching_pairs.h>
#include <softgrain/driving/balance.h>
#include <softgrain/driving/wall.h>
#include <softgrain/geometry/shapes_2d.h>

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
WallDescription<2> wall(const std::string &name,
                        const dealii::Point<2> &point,
                        const dealii::Point<2> &normal,
                        const std::shared_ptr<const WallDrive> &drive)
{
  WallDescription<2> result;
  result.name = name;
  result.point = point;
  result.normal = normal;
  result.drive = drive;
  return result;
}
} // namespace

int main()
{
  const auto rest = make_drive("velocity", "Walls/rest");
  const auto pressed = make_drive("pressure", "Walls/top", {"Pressure=100*t", "Mass=2", "Damping=3"});
  Scene<2> scene;
  scene.walls = {wall("bottom", {0, 0}, {0, 1}, rest), wall("top", {0, 1}, {0, -1}, pressed),
                 wall("left", {0, 0}, {1, 0}, make_drive("velocity", "Walls/left", {"Velocity=t"})),
                 wall("right", {3, 0}, {-1, 0}, rest)};
  std::vector<Wall<2>> walls = make_walls(scene);
  // v = t is linear: the middle of each step is exact.
  double time = 0.;
  for (const double dt : {0.1, 0.4, 0.5})
  {
    walls[2].speed = demand_of(walls[2], time, dt).velocity;
    walls[2].travel += dt * walls[2].speed;
    time += dt;
  }
  std::cout << "left is at " << state_of(walls[2]).position << ", 1/2 expected\n";
  put_pressure(walls[1], demand_of(walls[1], time, 1.).pressure, pressed_length(walls, 1));
  std::cout << "top: " << (walls[1].prescribed() ? "prescribed" : "free") << ", pressure "
            << demand_of(walls[1], time, 1.).pressure << " on " << pressed_length(walls, 1) << " m, load "
            << walls[1].free.across.force << ", mass " << walls[1].free.across.mass << ", damping "
            << walls[1].free.across.damping << '\n';
  // At rest under P = load dt it stays at rest, whatever mass, damping and theta are.
  for (const double theta : {0.5, 1.})
  {
    const FreeWallStep step = free_wall_step(walls[1], 0.1, theta);
    std::cout << "  theta " << theta << ": given what it bears it moves at "
              << step.free_speed - 0.1 * walls[1].free.across.force / step.mass << " m/s\n";
  }
  // What nobody gives the program chooses: of one disk of 1 kg/m, a tenth.
  Scene<2> disk = scene;
  disk.walls[1].drive = make_drive("pressure", "Walls/top", {"Pressure=160"});
  disk.materials.push_back({"", "", 1. / M_PI});
  disk.bodies.emplace_back();
  disk.bodies[0].shape = std::make_shared<Disk2D>(dealii::Point<2>(), 1.);
  Wall<2> chosen = make_walls(disk)[1];
  put_pressure(chosen, 160., 1.);
  std::cout << "chosen mass " << chosen.free.across.mass << ", damping " << chosen.free.across.damping
            << ", expected 0.1 and 8\n";
  std::cout << "length of left " << pressed_length(walls, 2) << ", without walls beside it "
            << pressed_length({walls[0], walls[1]}, 0) << '\n';

  // A step that is refused is tried again from the same pressure: 0.4 of the way to what is asked.
  disk.walls[1].drive = make_drive("mean_pressure", "Walls/top", {"Mean pressure=50"});
  Wall<2> beside = make_walls(disk)[1];
  for (const bool accepted : {false, false, true, true})
  {
    put_pressure(beside, demand_of(beside, 0., 1.).pressure, 1.);
    if (accepted)
      accept_pressure(beside);
    std::cout << (accepted ? "accepted" : "refused") << " at " << beside.free.pressure << " Pa; ";
  }
  std::cout << "40, 40, 40 and 64 expected\n";

  // A wall that pushes down and to the right: 2 N s/m within 0.1 s.
  Balance balance;
  balance.momentum.initial[0] = 1.;
  walls[1].book.give(2. * walls[1].normal() + 0.5 * walls[1].tangent(), 0.1);
  balance.momentum.of_walls += walls[1].book.impulse;
  const WallState<2> state = state_of(walls[1]);
  std::cout << "force " << state.normal_force << ' ' << state.tangential_force << ", impulse "
            << walls[1].book.impulse << '\n';
  balance.momentum.note(1.);
  std::cout << "momentum error " << balance.momentum.error(walls[1].book.impulse) << " of "
            << balance.momentum.largest << ", expected 1/sqrt(4.25)\n";

  TouchingPairs touching;
  touching.add_bodies(0, 1);
  touching.add_bodies(1, 0);
  touching.add_bodies(2, 2);
  touching.add_wall(0, 3);
  touching.add_wall(0, 3);
  std::cout << "coordination " << touching.coordination(3) << ", nobody there " << touching.coordination(0)
            << '\n';
}
