// SPDX-License-Identifier: LGPL-2.1-or-later
// The same state, bit for bit, with one thread and with two, and for a run that was saved and continued
// twice.
#include "bpm_scene.h"
#include "continued.h"

#include <softgrain/base/parallel.h>

#include <iostream>

using namespace softgrain;

namespace
{
const std::string scene = R"(
subsection Packing
  set Number = 12
  set Smallest diameter = 16
  set Largest diameter = 24
  set Lower = 0, 0
  set Upper = 68, 80
end
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, 0
  end
  subsection top
    set Point = 0, 80
    set Velocity = 0.3
  end
  subsection left
    set Point = 0, 0
  end
  subsection right
    set Point = 68, 0
    set Drive = pressure
    set Pressure = 0.05
    set Mass = 300
  end
end
)";

std::string steps(bpm::BpmModel &model, const unsigned int from, const unsigned int to)
{
  std::ostringstream text;
  text << std::hexfloat;
  for (unsigned int i = from; i < to; ++i)
  {
    const StepReport report = model.advance(1.);
    const Energies energies = model.energies();
    text << model.time() << ' ' << report.contact_sweeps << ' ' << report.contact_residual << ' '
         << energies.kinetic << ' ' << energies.elastic << ' ' << energies.dissipated << ' '
         << energies.external_work << ' ' << model.momentum_error() << ' ' << model.solid_area() << ' '
         << model.coordination();
    for (const auto &wall : model.walls())
      text << ' ' << wall.normal_force << ' ' << wall.tangential_force << ' ' << wall.position;
    text << '\n';
  }
  return text.str();
}

void compare(const std::string &what, const Changes &changes)
{
  const unsigned int n = 240;
  set_n_threads(1);
  const std::string one = steps(*bpm_scene(grain_scene(scene), changes), 0, n);
  set_n_threads(2);
  const std::string two = steps(*bpm_scene(grain_scene(scene), changes), 0, n);
  const std::string parts = continued_twice(
      n, [&] { return bpm_scene(grain_scene(scene), changes); }, steps);
  std::cout << what << ": two threads " << (one == two ? "the same" : "DIFFERENT") << ", continued twice "
            << (one == parts ? "the same" : "DIFFERENT") << '\n';
}
} // namespace

int main()
{
  compare("frictionless", {});
  compare("friction and rolling resistance", {"Contact/Friction=0.5", "Contact/Rolling resistance=0.1"});
  const std::string of_walls = "Contact/Adhesion of pairs=m / bottom: 0.2; m / left: 0",
                    rough = "Contact/Friction of pairs=m / bottom: 0.5; m / m: 0.2";
  compare("cohesion and tables", {"Contact/Law=cohesive", "Contact/Adhesion=0.1", of_walls, rough});
  compare("graded strength", {"Primaries/Strength=2 - r", "Primaries/Strength spread=0.3"});
  compare("bonds", {"Contact/Law=bond", "Contact/Adhesion=0.1", "Contact/Healing time=5", of_walls, rough});
  Changes cell = {"Contact/Friction=0.5", "Walls/top/Tangential velocity=-0.3"};
  for (const std::string wall : {"bottom", "top", "left", "right"})
    cell.push_back("Walls/" + wall + "/Type=periodic");
  compare("cell that repeats", cell);
  compare("obstacle", {"Obstacles/Names=plate", "Obstacles/plate/Points=-10, 0; 90, 0",
                       "Obstacles/plate/Displacement=0; 0.1*t", "Obstacles/plate/Angle=0.05*t",
                       "Obstacles/plate/Friction=0.5"});
}
