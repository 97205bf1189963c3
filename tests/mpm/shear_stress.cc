// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls under a shear stress. In balance a block between two plates passes on to the floor exactly what the
// lid bears, along both directions; a lid that slides obeys Newton's law.
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
const std::string block = R"(
subsection Mesh
  set Lower     = -2e-3, -1e-3
  set Upper     = 12e-3, 6e-3
  set Cell size = 5e-4
end
)" + gel("0.3") + R"(subsection Bodies
  set Names = block
  subsection block
    set Shape  = rectangle
    set Center = 5e-3, 2e-3
    set Size   = 8e-3, 4e-3
  end
end
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Friction = 0.9
  end
  subsection top
    set Point        = 0, 4e-3
    set Drive        = pressure
    set Pressure     = 2e5
    set Friction     = 0.9
    set Shear stress = 5e4
  end
  subsection right
    set Point = 10e-3, 0
  end
end
subsection Stop
  set End time = 1
end
)";

void statics()
{
  const auto model = scene_of_text(block, {"Time/Scheme=quasi_static", "Time/Time step=1e-4"});
  model->advance(1.);
  const auto walls = model->walls();
  const double length = walls[3].position - walls[2].position;
  // The tangent of the lid points to -x, that of the floor to +x.
  std::cout << "block in balance: load off by " << below(2e-3, walls[1].normal_force / (2e5 * length) - 1.)
            << " and " << below(2e-3, -walls[1].tangential_force / (5e4 * length) - 1.)
            << ", on the floor by " << below(2e-3, walls[0].normal_force / (2e5 * length) - 1.) << " and "
            << below(2e-3, -walls[0].tangential_force / (5e4 * length) - 1.) << std::endl;
}

void slides()
{
  // The lid goes down a little, then stays at its height and slides.
  const auto model = scene_of_text(
      block, {"Time/Scheme=moreau_jean", "Time/Time step=2e-6", "Walls/top/Drive=velocity",
              "Walls/top/Pressure=0", "Walls/top/Velocity=t < 2e-5 ? 5 : 0", "Walls/top/Friction=0.2",
              "Walls/top/Shear stress=t < 2e-5 ? 0 : 3e5", "Materials/gel/Density=9900"});
  EnergyWatch energy(*model);
  double off = 0., speed = 0.;
  for (unsigned int i = 0; i < 30; ++i)
  {
    const double before = model->walls()[1].slide_velocity;
    model->advance(1.);
    const auto lid = model->walls()[1];
    energy.look(*model);
    if (i < 15)
      continue;
    // A tenth of the mass of the block; damping as it is chosen.
    const double mass = 0.1 * 9900 * 32e-6, damping = 2. * std::sqrt(mass * 3e5),
                 dt = model->time() / (i + 1);
    const double mean = 0.5 * (before + lid.slide_velocity);
    off = std::max(off, std::abs(mass * (lid.slide_velocity - before) / dt + damping * mean -
                                 (3e5 * 10e-3 + lid.tangential_force)) /
                            (3e5 * 10e-3));
    speed = lid.slide_velocity;
  }
  std::cout << "lid that slides: goes " << (speed > 0. ? "along its tangent" : "the other way")
            << ", Newton's law off by " << below(0.02, off) << ", energy from nowhere "
            << below(0.01, energy.gained()) << std::endl;
}
} // namespace

int main()
{
  statics();
  slides();
}
