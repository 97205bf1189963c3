// SPDX-License-Identifier: LGPL-2.1-or-later
// A material that names no law is neo_hookean, with the constants of that section, however many laws there
// are.
#include "scene_of.h"

#include <iostream>

int main()
{
  using namespace softgrain;
  const std::string text = R"(
subsection Mesh
  set Lower     = -2e-3, -2e-3
  set Upper     = 12e-3, 12e-3
  set Cell size = 2e-3
end
subsection Materials
  set Names = stuff
  subsection stuff
    subsection Neo-Hookean
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
    end
  end
end
subsection Bodies
  set Names = block
  subsection block
    set Shape  = rectangle
    set Center = 5e-3, 5e-3
    set Size   = 10e-3, 10e-3
  end
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, 0
  end
  subsection top
    set Point    = 0, 10e-3
    set Drive    = position
    set Position = 1e-6*t
  end
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 1
end
subsection Stop
  set End time = 1
end
)";
  const auto model = scene_of_text(text);
  run_until(*model, 1.);
  std::cout << "pressed by 1e-4, stress / (E/(1 - nu^2)) / 1e-4: "
            << model->walls()[1].normal_force / 0.01 / (1e6 / 0.91 * 1e-4) << '\n';
}
