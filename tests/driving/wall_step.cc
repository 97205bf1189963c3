// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps by the way of the fastest wall: the way that is asked for at constant speed, never more when it
// becomes faster or comes back, and no step where no wall is told to move.
#include <softgrain/driving/wall_step.h>

#include <iostream>

using namespace softgrain;

int main()
{
  const double way = 1e-2;
  const auto look = [&](const std::string &what, const std::vector<std::string> &drives, const double time)
  {
    Scene<2> scene;
    for (const std::string &velocity : drives)
    {
      WallDescription<2> wall;
      wall.name = "wall";
      wall.normal = dealii::Point<2>(0., 1.);
      wall.drive = make_drive("velocity", "Walls/wall", {"Velocity=" + velocity});
      scene.walls.push_back(wall);
    }
    const std::vector<Wall<2>> walls = make_walls(scene);
    const double dt = step_of_wall_way(walls, time, way, 1e-6, 1e6);
    double gone = 0.;
    for (const Wall<2> &wall : walls)
      gone = std::max(gone, std::abs(demand_of(wall, time, dt).velocity) * dt);
    std::cout << what << ": step " << dt << " s, way " << gone << " m\n";
  };
  look("one at 2 m/s", {"2"}, 0.);
  look("the faster of two counts", {"0.5", "-4"}, 0.);
  look("so fast that the shortest step is too long", {"1e6"}, 0.);
  look("faster and faster", {"100*t"}, 0.);
  look("to and fro", {"3*cos(1000*t)"}, 0.);
  look("turning back", {"3*cos(100*t)"}, 0.01570796);
  look("at rest", {"0"}, 0.);
  look("none", {}, 0.);
}
