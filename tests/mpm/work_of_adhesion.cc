// SPDX-License-Identifier: LGPL-2.1-or-later
// In balance adhesion does what its law does over the way of the surfaces: of a disk that rolls on a plate,
// in steps of a third of the width that is held, what it has done is no more than what parting them would
// take, however far the disk has rolled. With the pull of the start of a step nothing would be booked of what
// comes into range within it, and all of the way of what leaves.
#include "scene_of.h"

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
/// A wall without adhesion pushes a disk along a plate that holds it, and on which it does not slide.
const std::string scene = R"(
subsection Mesh
  set Lower     = -6e-3, -2e-3
  set Upper     = 12e-3, 10e-3
  set Cell size = 1e-3
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 5e-2
end
subsection Materials
  set Names = gel
  subsection gel
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 2e6
      set Poisson's ratio = 0.3
    end
  end
end
subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 4e-3
    set Center = 0, 4e-3
  end
end
subsection Walls
  set Names = bottom, left
  subsection left
    set Point    = -4e-3, 0
    set Drive    = position
    set Position = 4e-3*t
  end
end
subsection Contact
  set Law               = cohesive
  set Adhesion          = 1e4
  set Adhesion range    = 5e-5
  set Adhesion of pairs = gel / left: 0
  set Friction of pairs = gel / bottom: 1
end
subsection Stop
  set End time = 1
end
)";

double work_of_adhesion(const mpm::MpmModel &model)
{
  for (const auto &[name, value] : model.works())
    if (name == "adhesion_work_J_per_m")
      return value;
  return 0.;
}
} // namespace

int main()
{
  const auto model = scene_of_text(scene);
  // Times the width that is held of a disk that is stiff.
  const double to_part = 1e4 * 5e-5 * 2. * std::sqrt(2. * 4e-3 * 5e-5);
  double most = 0.;
  run_until(*model, 1.,
            [&](const StepReport &) { most = std::max(most, std::abs(work_of_adhesion(*model))); });
  std::cout << "work of adhesion over what parting takes " << below(0.5, most / to_part) << '\n';
}
