// SPDX-License-Identifier: LGPL-2.1-or-later
// A disk that nothing touches, without inertia: in one step its weight W moves it by W / (α E Σ|m| / Σm) with
// the masses m of its nodes, for what resists it is α E |m| / Σm at each node. Quadratic functions make some
// masses negative; what resists must not push there.
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

int main()
{
  constexpr double resistance = 1e-3, young = 1e7, gravity = 20.;
  for (const std::string functions : {"quadratic", "bspline"})
  {
    const auto model = scene_of_text(
        gel("0.3", "1e7", "1000") + R"(
subsection Mesh
  set Lower     = -8e-3, -8e-3
  set Upper     = 8e-3, 8e-3
  set Cell size = 1e-3
end
subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 4.3e-3
    set Center = 0.31e-3, 0.17e-3
  end
end
subsection Loads
  set Gravity = 0, -20
end
subsection Quasi-static
  set Regularisation = 1e-3
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 1
end
subsection Stop
  set End time = 1
end
)",
        {"Material points/Shape function=" + functions, "Material points/Points per direction=3"});
    const Eigen::VectorXd mass = model->bodies()[0].nodes.mass;
    const double before = model->bodies()[0].center()[1];
    model->advance(1.);
    const double way = before - model->bodies()[0].center()[1], weight = mass.sum() * gravity;
    std::cout << functions << ": nodes with much negative mass "
              << (mass.cwiseAbs().sum() > 1.02 * mass.sum() ? "some" : "none")
              << ", way over the expected one "
              << way / (weight / (resistance * young * mass.cwiseAbs().sum() / mass.sum()))
              << ", takes energy " << (model->energies().dissipated > 0. ? "yes" : "no") << '\n';
  }
}
