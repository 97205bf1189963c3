// SPDX-License-Identifier: LGPL-2.1-or-later
// A disk of gel without friction lies beside the lowest place of a bowl, a quarter wider than it. What brings
// it there is its weight alone: a spring W / (R - r), less than a ten thousandth of what resists it in the
// first held step. Held steps come to less and less resistance, so that it ends at the lowest place after
// some tens of them. How far it would fall within the step does not matter, for nothing has inertia.
#include "gel.h"
#include "scene_of.h"

#include <softgrain/base/exceptions.h>

#include <iostream>

using namespace softgrain;

namespace
{
const std::string scene = gel("0.3", "1e7", "1000") + R"(
subsection Mesh
  set Lower     = -8e-3, -8e-3
  set Upper     = 8e-3, 8e-3
  set Cell size = 2e-3
end
subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 4e-3
    set Center = 0.1e-3, -0.99e-3
  end
end
subsection Obstacles
  set Names = bowl
  subsection bowl
    set Shape  = arc
    set Center = 0, 0
    set Radius = 5e-3
    set From   = 180
    set To     = 360
  end
end
subsection Loads
  set Gravity = 0, -1
end
subsection Quasi-static
  set Unbalanced force = 1e-9
end
subsection Newton
  set Residual tolerance = 1e-9
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 1
end
subsection Stop
  set End time = 1
end
)";

/// What is said when held steps are too few.
void too_few(const std::vector<std::string> &changes)
{
  const auto model = scene_of_text(scene, changes);
  try
  {
    StepReport report = model->advance(1.);
    model->settle(report);
    std::cout << "they are enough\n";
  }
  catch (const ComputationError &error)
  {
    const std::string what = error.what();
    std::cout << "too few held steps: " << what.substr(what.rfind("; ") + 2, 36) << '\n';
  }
}
} // namespace

int main()
{
  const auto model = scene_of_text(scene);
  StepReport report = model->advance(1.);
  model->settle(report);
  std::cout << "off the lowest place by " << below(1e-4, model->bodies()[0].center()[0] / 2e-3)
            << " cells, in fewer than 400 iterations " << (report.newton_iterations < 400 ? "yes" : "no")
            << ", a step of " << report.dt << " s\n";
  too_few({"Quasi-static/Held steps=3"});
  too_few({"Quasi-static/Held steps=3", "Walls/Names=bottom, top, left, right", "Walls/bottom/Point=0, -7e-3",
           "Walls/top/Point=0, 7e-3", "Walls/left/Point=-7e-3, 0", "Walls/right/Point=7e-3, 0",
           "Walls/top/Shear stress=1", "Walls/top/Friction=0.5"});
}
