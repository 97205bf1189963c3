// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls under pressure. One disk between a pressed wall and a floor: the force is pressure times length, in
// every state of quasi_static and in the mean of dynamic schemes, for planes and slabs, with every solver,
// whatever mass, damping and the largest way of the wall are. Fifteen and thirty grains under four walls: the
// stresses on all of them are the pressure.
#include "continued.h"
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;

const std::string one_disk = R"(
subsection Mesh
  set Lower     = -12e-3, -5e-3
  set Upper     = 12e-3, 15e-3
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
  set Names = bottom, top, left, right
  subsection top
    set Point = 0, 10.2e-3
    set Drive = pressure
  end
  subsection left
    set Point = -8e-3, 0
  end
  subsection right
    set Point = 8e-3, 0
  end
end
subsection Stop
  set End time = 1
end
)";

/// From balance to balance under a pressure that rises and falls.
void in_balance(const std::string &what, const Changes &changes)
{
  Changes all = {"Time/Scheme=quasi_static", "Time/Time step=1e-4",
                 "Walls/top/Pressure=t < 4.5e-4 ? 1e9*t : 1e9*(9e-4 - t)"};
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = scene_of_text(one_disk, all);
  double worst = 0., height_at_top = 0.;
  for (unsigned int i = 1; i <= 8; ++i)
  {
    model->advance(1.);
    const double pressure = 1e5 * std::min(i, 9 - i);
    for (const unsigned int w : {0, 1})
      worst = std::max(worst, std::abs(model->walls()[w].normal_force / (pressure * 16e-3) - 1.));
    if (i == 4)
      height_at_top = model->walls()[1].position;
  }
  std::cout << what << ": force off by " << below(1.1e-4, worst) << ", height " << height_at_top
            << " m under "
            << "the largest, " << model->walls()[1].position << " m under the last pressure\n";
}

/// Under a pressure that stays.
void in_motion(const std::string &what, const Changes &changes)
{
  Changes all = {"Walls/top/Pressure=1e5", "Time/CFL multiple=10"};
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = scene_of_text(one_disk, all);
  EnergyWatch energy(*model);
  double force[2] = {0., 0.}, height = 0.;
  const double from = 5e-3, end = 15e-3;
  run_until(*model, end,
            [&](const StepReport &report)
            {
              energy.look(*model);
              if (model->time() <= from)
                return;
              for (const unsigned int w : {0, 1})
                force[w] += report.dt / (end - from) * model->walls()[w].normal_force;
              height += report.dt / (end - from) * model->walls()[1].position;
            });
  std::cout << what << ": mean force off by " << below(0.01, force[0] / 1600. - 1.) << " below and "
            << below(0.01, force[1] / 1600. - 1.) << " above, mean height " << height
            << " m, energy from nowhere " << below(0.05, energy.gained()) << ", momentum error "
            << below(1e-12, model->momentum_error()) << '\n';
}

/// Grains under equal pressures on four walls.
void grains(const std::string &what, const Changes &changes)
{
  Changes all = {"Mesh/Cell size=4e-4", "Time/Time step=1e-4", "Time/Wall way=0", "Walls/top/Velocity=0",
                 "Walls/top/Pressure=2e9*t"};
  for (const std::string wall : {"bottom", "top", "left", "right"})
    for (const std::string key : {"Drive=pressure", "Pressure=2e9*t"})
      all.push_back("Walls/" + wall + "/" + key);
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = shipped_scene("gallery/thirty_grains_quasi_static_mpm.prm", all);
  double worst = 0., fraction = 0.;
  for (unsigned int i = 1; i <= 3; ++i)
  {
    model->advance(1.);
    const auto walls = model->walls(); // bottom, top, left, right
    const double width = walls[3].position - walls[2].position,
                 height = walls[1].position - walls[0].position;
    for (const unsigned int w : {0, 1, 2, 3})
      worst = std::max(worst, std::abs(walls[w].normal_force / (w < 2 ? width : height) / (2e5 * i) - 1.));
    fraction = model->solid_area() / (width * height);
  }
  std::cout << what << ": stresses off by " << below(5e-4, worst) << ", packing fraction " << fraction
            << '\n';
}

/// Thirty grains compacted under equal pressures, then the upper wall goes down and the one on the right
/// follows the stress that this makes.
void follow(const std::string &what, const Changes &changes)
{
  Changes all = {"Mesh/Cell size=4e-4",        "Time/Time step=1e-4",      "Time/Wall way=0",
                 "Walls/top/Velocity=0",       "Walls/top/Drive=pressure", "Walls/top/Pressure=1e5",
                 "Walls/right/Drive=pressure", "Walls/right/Pressure=1e5"};
  const auto compacted = shipped_scene("gallery/thirty_grains_quasi_static_mpm.prm", all);
  compacted->advance(1.);
  for (const std::string change :
       {"Walls/top/Drive=position", "Walls/top/Pressure=0", "Walls/right/Pressure=0"})
    all.push_back(change);
  const double reached = 10.6e-3 - compacted->walls()[1].position;
  std::ostringstream position;
  position.precision(17);
  position << "Walls/top/Position=t == 0 ? 0 : " << reached << " + (t - 1e-4)";
  all.push_back(position.str());
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = shipped_scene("gallery/thirty_grains_quasi_static_mpm.prm", all);
  take_state(*compacted, *model);
  for (unsigned int i = 0; i < 3; ++i)
    model->advance(1.);
  const auto walls = model->walls(); // bottom, top, left, right
  const double width = walls[3].position - walls[2].position, height = walls[1].position - walls[0].position,
               vertical = 0.5 * (walls[0].normal_force + walls[1].normal_force) / width,
               right = walls[3].normal_force / height;
  std::cout << what << ": way off by " << below(1e-15, 10.6e-3 - walls[1].position - reached - 3e-4)
            << " m, vertical stress " << vertical << " Pa, mean of both " << 0.5 * (vertical + right)
            << " Pa, right over vertical " << right / vertical << '\n';
}
} // namespace

int main()
{
  in_balance("one disk", {});
  in_balance("half the way a step", {"Quasi-static/Wall motion=0.15"});
  in_balance("half the regularisation", {"Quasi-static/Regularisation=5e-4"});
  in_balance("slab", {"Walls/top/Type=material points"});
  in_balance("friction", {"Walls/top/Friction=0.5", "Walls/bottom/Friction=0.5"});
  in_balance("slab with friction",
             {"Walls/top/Type=material points", "Walls/top/Friction=0.5", "Walls/bottom/Friction=0.5"});

  in_motion("moreau_jean", {});
  const std::string mass = "Walls/top/Mass=", damping = "Walls/top/Damping=";
  in_motion("mass and damping given", {mass + "0.016", damping + "80"});
  in_motion("both halved", {mass + "0.008", damping + "40"});
  in_motion("newmark", {"Time/Scheme=newmark"});
  in_motion("explicit", {"Time/Scheme=explicit", "Time/CFL multiple=0.5"});
  in_motion("slab", {"Walls/top/Type=material points"});
  in_motion("friction, sweeps", {"Walls/top/Friction=0.5", "Contact/Algorithm=gauss_seidel"});
  in_motion("active set", {"Contact/Algorithm=active_set"});

  // Without friction, thirty take ten times as long.
  Changes fifteen = {
      "Packing/Number=15",         "Packing/Packing fraction=0.7", "Packing/Upper=7.2e-3, 7.2e-3",
      "Walls/top/Point=0, 7.2e-3", "Walls/right/Point=7.2e-3, 0",  "Mesh/Upper=8.2e-3, 8.2e-3"};
  grains("fifteen grains", fifteen);
  fifteen.push_back("Quasi-static/Regularisation=5e-4");
  grains("half the regularisation", fifteen);
  grains("thirty grains, friction 0.5", {"Contact/Friction=0.5"});

  follow("mean pressure", {"Walls/right/Drive=mean_pressure", "Walls/right/Mean pressure=1e5"});
  follow("stress ratio", {"Walls/right/Drive=stress_ratio", "Walls/right/Stress ratio=0.8"});
}
