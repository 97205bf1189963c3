// SPDX-License-Identifier: LGPL-2.1-or-later
// The length of a step where the file gives none: the fastest wall goes a tenth of a cell, and with inertia
// no more than 20 CFL steps pass where more than walls moves bodies. What the file gives counts.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;
const double cell = 4.2e-4, speed = 0.2;

void look(const std::string &what, const Changes &more)
{
  Changes changes = {"Mesh/Cell size=4.2e-4", "Time/CFL multiple=0"};
  changes.insert(changes.end(), more.begin(), more.end());
  const auto model = shipped_scene("thesis/diametral_compression_mpm.prm", changes);
  const double step = model->wanted_step();
  std::cout << what << ": a wall at 0.2 m/s would go " << speed * step / cell << " cells in "
            << step / model->cfl_step() << " CFL steps\n";
}
} // namespace

int main()
{
  const Changes rest = {"Time/Scheme=quasi_static"}, gravity = {"Loads/Gravity=0, -9.81"};
  const auto with = [](Changes one, const Changes &other)
  {
    one.insert(one.end(), other.begin(), other.end());
    return one;
  };
  look("nothing given", {});
  look("a wall ten times as fast", {"Walls/top/Velocity=2"});
  look("a wall that only slides",
       {"Walls/top/Velocity=0", "Walls/top/Tangential velocity=0.2", "Walls/top/Friction=0.3"});
  look("no wall moves", {"Walls/top/Velocity=0"});
  look("gravity", gravity);
  look("gravity, a wall at 20 m/s", with(gravity, {"Walls/top/Velocity=20"}));
  look("a body that is thrown", {"Bodies/disk/Velocity=0.1 * y; 0"});
  look("a body that turns", {"Bodies/disk/Angular velocity=3"});
  look("a wall under pressure",
       {"Walls/bottom/Drive=pressure", "Walls/bottom/Pressure=1e4", "Walls/Names=bottom, top, left, right",
        "Walls/left/Point=-6e-3, 0", "Walls/right/Point=6e-3, 0"});
  look("at rest", rest);
  look("at rest, gravity", with(rest, gravity));
  look("at rest, 4 CFL", with(rest, {"Time/CFL multiple=4"}));
  look("a step of 1e-5 s", {"Time/Time step=1e-5"});
  look("4 CFL", {"Time/CFL multiple=4"});
  look("0.3 cells, gravity", with(gravity, {"Time/Wall way=0.3"}));
  look("explicit", {"Time/Scheme=explicit"});
}
