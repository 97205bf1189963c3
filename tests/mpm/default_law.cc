// SPDX-License-Identifier: LGPL-2.1-or-later
// A material that names no law is neo_hookean, with the constants of that section, however many laws there
// are.
#include "block.h"
#include "scene_of.h"

#include <iostream>

int main()
{
  using namespace softgrain;
  const auto model = scene_of_text(
      block(R"(
    subsection Neo-Hookean
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
    end)"),
      {"Time/Time step=1", "Stop/End time=1", "Walls/top/Drive=position", "Walls/top/Position=1e-6*t"});
  run_until(*model, 1.);
  std::cout << "pressed by 1e-4, stress / (E/(1 - nu^2)) / 1e-4: "
            << model->walls()[1].normal_force / 0.01 / (1e6 / 0.91 * 1e-4) << '\n';
}
