// SPDX-License-Identifier: LGPL-2.1-or-later
// A scene in kilograms of half the size, so that every stress and density is twice the number: all lengths
// are the same to the last bit, since a product with 2 is exact. Roots of matrices and sums of squares of
// forces and ways would break that. Rough grains pressed without inertia, and thrown at each other.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
std::string state(const mpm::MpmModel &model)
{
  std::ostringstream text;
  text << std::hexfloat << model.time();
  for (const auto &body : model.bodies())
    text << ' ' << body.nodes.displacement.sum() << ' ' << body.nodes.displacement.squaredNorm();
  return text.str();
}

std::string after(const std::string &file,
                  std::vector<std::string> changes,
                  const double kilograms,
                  const unsigned int steps)
{
  for (const auto &[key, value] :
       {std::pair<std::string, double>{"Density", 990.}, {"Neo-Hookean/Young's modulus", 1e7}})
    changes.push_back("Materials/gel/" + key + "=" + std::to_string(kilograms * value));
  const auto model = shipped_scene(file, changes);
  for (unsigned int i = 0; i < steps; ++i)
  {
    StepReport report = model->advance(1.);
    model->settle(report);
  }
  return state(*model);
}

void compare(const std::string &what,
             const std::string &file,
             const std::vector<std::string> &changes,
             const unsigned int steps)
{
  std::cout << what << ": with stresses twice as large "
            << (after(file, changes, 1., steps) == after(file, changes, 2., steps) ? "same" : "differs")
            << '\n';
}
} // namespace

int main()
{
  const std::vector<std::string> few = {"Packing/Number=5",          "Packing/Packing fraction=0.6",
                                        "Mesh/Cell size=5e-4",       "Packing/Upper=4.4e-3, 4.4e-3",
                                        "Walls/top/Point=0, 4.4e-3", "Walls/right/Point=4.4e-3, 0",
                                        "Mesh/Upper=5.4e-3, 5.4e-3", "Contact/Friction=0.3"};
  for (const std::string solver : {"banded_cholesky", "cholesky"})
  {
    std::vector<std::string> changes = few;
    changes.push_back("Linear solver/Type=" + solver);
    compare("pressed, " + solver, "gallery/thirty_grains_quasi_static_mpm.prm", changes, 3);
    compare("thrown, " + solver, "gallery/two_disks.prm",
            {"Contact/Friction=0.3", "Linear solver/Type=" + solver, "Mesh/Cell size=8e-4"}, 8);
  }
}
