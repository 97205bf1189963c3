// SPDX-License-Identifier: LGPL-2.1-or-later
// Extremes run, or end with one clear message; nothing is ever infinite or NaN.
#include "scene_of.h"

#include <softgrain/base/exceptions.h>

#include <iostream>

using namespace softgrain;

namespace
{
void attempt(const std::string &what,
             const std::string &file,
             const std::vector<std::string> &changes,
             const unsigned int n = 8)
{
  std::cout << what << ": ";
  try
  {
    const auto model = shipped_scene(file, changes);
    EnergyWatch energy(*model);
    bool finite = true;
    for (unsigned int i = 0; i < n; ++i)
    {
      model->advance(1.);
      energy.look(*model);
      for (const auto &body : model->bodies())
        finite = finite && body.nodes.velocity.allFinite() && body.nodes.displacement.allFinite();
    }
    const Energies e = model->energies();
    finite = finite && std::isfinite(e.kinetic + e.elastic + e.dissipated + e.external_work);
    std::cout << (finite ? "runs" : "is not finite") << ", energy gained "
              << below(0.02, std::max(0., energy.gained())) << '\n';
  }
  catch (const InputError &error)
  {
    std::cout << "refused: " << std::string(error.what()).substr(std::string(error.what()).find(".prm") + 6)
              << '\n';
  }
  catch (const ComputationError &error)
  {
    std::cout << "ends: " << error.what() << '\n';
  }
}
} // namespace

int main()
{
  const std::string two = "gallery/two_disks.prm", nu = "Materials/gel/Neo-Hookean/Poisson's ratio=";
  const std::string slow = "Time/CFL multiple=5";
  for (const std::string value : {"0", "0.49", "0.4999"})
    attempt("nu " + value, two, {nu + value, slow}, 20);
  for (const std::string value : {"0.01", "1", "100", "1000"})
    attempt("CFL multiple " + value, two,
            {"Time/CFL multiple=" + value, "Bodies/left/Center=-5e-3, 0", "Bodies/right/Center=5e-3, 0"});
  for (const std::string value : {"0", "1", "10"})
    attempt("mu " + value, two,
            {"Contact/Friction=" + value, "Bodies/left/Center=-5.1e-3, 2e-3", "Mesh/Upper=0.0105, 0.009"},
            20);
  attempt("one point per body", two,
          {"Mesh/Lower=-0.065, -0.065", "Mesh/Upper=0.065, 0.065", "Mesh/Cell size=1.3e-2",
           "Material points/Points per direction=1", "Time/Time step=5e-5"},
          20);
  attempt("initial overlap", two, {"Bodies/left/Center=-4.98e-3, 0", "Bodies/right/Center=4.98e-3, 0"});
  attempt("no gravity, no velocity", two, {"Bodies/left/Velocity=0; 0", "Bodies/right/Velocity=0; 0"});
  attempt("at rest, touching", two,
          {"Bodies/left/Center=-5e-3, 0", "Bodies/right/Center=5e-3, 0", "Bodies/left/Velocity=0; 0",
           "Bodies/right/Velocity=0; 0"});
  attempt("100 m/s", two, {"Bodies/left/Velocity=100; 0", "Time/CFL multiple=1"}, 20);
  attempt("stiffness 1e-2 Pa", two,
          {"Materials/gel/Neo-Hookean/Young's modulus=1e-2", "Time/Time step=3e-5"});
  attempt("stiffness 1e12 Pa", two, {"Materials/gel/Neo-Hookean/Young's modulus=1e12", "Time/Time step=3e-5"},
          20);
}
