// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearly incompressible disk between plates (line_contact): with F-bar the force is right on a coarse mesh
// already and does not depend on how near to 1/2 Poisson's ratio is; without it the mesh locks.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
double force(const std::string &shape,
             const std::string &nu,
             const std::string &cell,
             const std::string &f_bar,
             unsigned int &iterations)
{
  const auto model = shipped_scene(
      "verification/line_contact.prm",
      {"Material points/Shape function=" + shape, "Materials/gel/Neo-Hookean/Poisson's ratio=" + nu,
       "Mesh/Cell size=" + cell, "Material points/F-bar=" + f_bar, "Time/Time step=0.02"});
  iterations = 0;
  run_until(*model, 0.1,
            [&](const StepReport &report) { iterations = std::max(iterations, report.newton_iterations); });
  return model->walls()[0].normal_force;
}
} // namespace

int main(int argc, char **)
{
  unsigned int iterations;
  const std::string fine = argc > 1 ? "2.9e-4" : "5.8e-4";
  const double reference = force("bspline", "0.4999", fine, "on", iterations);
  std::cout << "force at d/R = 0.1, h = " << fine << ": " << reference << " N/m\n";
  for (const std::string shape : {"linear", "bspline"})
    for (const std::string nu : {"0.499", "0.4999"})
      for (const std::string f_bar : {"on", "off"})
      {
        const double F = force(shape, nu, "1.16e-3", f_bar, iterations);
        std::cout << shape << " h 1.16e-3 nu " << nu << " F-bar " << f_bar << ": force over that "
                  << F / reference << ", Newton below 50 iterations: " << (iterations < 50 ? "yes" : "no")
                  << '\n';
        std::cerr << "Newton at most " << iterations << '\n';
      }
}
