// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls under pressure with inertia and steps of hundreds of CFL steps. A light wall that nothing bears yet
// would fly through the box in one: steps are cut until it meets the grains, and then grow. A stressed disk
// that rolls between two walls, a tenth of a radian a step: what the scheme takes from it is in the balance
// of energy, and falls with the step and with theta - 1/2.
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
void grains(const std::string &friction)
{
  std::vector<std::string> changes = {
      "Packing/Number=15",         "Packing/Packing fraction=0.7", "Packing/Upper=7.2e-3, 7.2e-3",
      "Walls/top/Point=0, 7.2e-3", "Walls/right/Point=7.2e-3, 0",  "Mesh/Upper=8.2e-3, 8.2e-3",
      "Mesh/Cell size=4e-4",       "Time/Scheme=moreau_jean",      "Time/Time step=1e-3",
      "Time/Wall way=0",           "Walls/top/Velocity=0",         "Contact/Friction=" + friction};
  for (const std::string wall : {"top", "right"})
    for (const std::string change : {"Drive=pressure", "Pressure=2e5"})
      changes.push_back("Walls/" + wall + "/" + change);
  const auto model = shipped_scene("gallery/thirty_grains_quasi_static_mpm.prm", changes);
  EnergyWatch energy(*model);
  unsigned int steps = 0;
  run_until(*model, 2e-2,
            [&](const StepReport &)
            {
              energy.look(*model);
              ++steps;
            });
  const auto walls = model->walls(); // bottom, top, left, right
  const double width = walls[3].position - walls[2].position, height = walls[1].position - walls[0].position;
  double worst = 0.;
  for (const unsigned int w : {1, 3})
    worst = std::max(worst, std::abs(walls[w].normal_force / (w == 1 ? width : height) / 2e5 - 1.));
  std::cout << "fifteen grains, friction " << friction << ": steps over 300 " << below(1., steps / 300.)
            << ", stresses in the end off by " << below(0.01, worst) << ", packing fraction above 0.75 "
            << (model->solid_area() > 0.75 * width * height ? "yes" : "no") << ", energy balance off by "
            << below(0.02, energy.error()) << '\n';
}

void rolling(const std::string &what, const std::vector<std::string> &changes)
{
  const auto model = scene_of_text(R"(
subsection Mesh
  set Lower     = -22e-3, -2e-3
  set Upper     = 22e-3, 12e-3
  set Cell size = 1e-3
end
)" + gel("0.45") + R"(subsection Bodies
  set Names = disk
  subsection disk
    set Center = 0, 5e-3
    set Radius = 5e-3
  end
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, 0
    set Friction = 0.8
  end
  subsection top
    set Point = 0, 10e-3
    set Friction = 0.8
    set Velocity = t < 2e-2 ? 5e-2 : 0
    set Tangential velocity = t < 2e-2 ? 0 : -0.5
  end
end
subsection Time
  set Scheme = moreau_jean
  set Time step = 2e-3
end
subsection Stop
  set End time = 1
end
)",
                                   changes);
  EnergyWatch energy(*model);
  run_until(*model, 4e-2, [&](const StepReport &) { energy.look(*model); });
  const double start = model->energies().dissipated;
  run_until(*model, 6e-2, [&](const StepReport &) { energy.look(*model); });
  const Energies end = model->energies();
  std::cout << "a disk that rolls, " << what << ": energy balance off by " << below(0.01, energy.error())
            << ", taken in a turn by a radian over what is stored " << (end.dissipated - start) / end.elastic
            << '\n';
}
} // namespace

int main()
{
  grains("0");
  grains("0.5");
  rolling("a tenth of a radian a step", {});
  rolling("half of that", {"Time/Time step=1e-3"});
  rolling("theta 0.55", {"Time/Theta=0.55"});
}
