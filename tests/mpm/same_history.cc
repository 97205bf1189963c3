// SPDX-License-Identifier: LGPL-2.1-or-later
// The same state, bit for bit, with one thread and with two, and for a run that was saved and continued
// twice.
#include "continued.h"
#include "scene_of.h"

#include <softgrain/base/mpi_session.h>
#include <softgrain/base/parallel.h>

#include <iostream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;

/// Numbers that differ as soon as anything does, one line per step.
std::string state(const mpm::MpmModel &model, const StepReport &report)
{
  std::ostringstream text;
  text << std::hexfloat << model.time() << ' ' << report.contact_sweeps << ' ' << report.newton_residual
       << ' ' << model.energies().elastic << ' ' << model.energies().dissipated << ' '
       << model.energies().external_work << ' ' << model.momentum_error();
  for (const auto &body : model.bodies())
    text << ' ' << body.nodes.velocity.sum() << ' ' << body.nodes.displacement.squaredNorm();
  for (const auto &wall : model.walls())
    text << ' ' << wall.normal_force << ' ' << wall.tangential_force;
  return text.str() + '\n';
}

/// Steps number @p from to @p to.
std::string steps(mpm::MpmModel &model, const unsigned int from, const unsigned int to)
{
  std::string text;
  for (unsigned int i = from; i < to; ++i)
  {
    StepReport report = model.advance(1.);
    model.settle(report);
    text += state(model, report);
  }
  return text;
}

std::string
whole(const std::string &file, const Changes &changes, const unsigned int n, const unsigned int threads)
{
  set_n_threads(threads);
  return steps(*shipped_scene(file, changes), 0, n);
}

void compare(const std::string &what, const std::string &file, const Changes &changes, const unsigned int n)
{
  const std::string two = whole(file, changes, n, 2);
  std::cout << what << ": two threads " << (whole(file, changes, n, 1) == two ? "same" : "differ");
  set_n_threads(2);
  const std::string parts = continued_twice(
      n, [&] { return shipped_scene(file, changes); }, steps);
  std::cout << ", in three parts " << (parts == two ? "same" : "differs") << '\n';
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  compare("impact", "gallery/two_disks.prm", {"Contact/Friction=0.3"}, 30);
  compare("grid update", "gallery/two_disks.prm", {"Material points/Grid update=every step"}, 30);
  compare("apic", "gallery/two_disks.prm",
          {"Material points/Grid update=every step", "Material points/Transfer=apic"}, 30);
  // A limit that the bodies pass at different times.
  compare("distortion", "gallery/two_disks.prm",
          {"Material points/Grid update=distortion", "Material points/Distortion limit=1.02",
           "Bodies/right/Radius=4e-3"},
          30);
  compare("newmark", "gallery/two_disks.prm", {"Time/Scheme=newmark"}, 30);
  compare("explicit", "gallery/two_disks.prm", {"Time/Scheme=explicit"}, 60);
  compare("sliding block", "verification/sliding_block.prm", {}, 20);
  compare("assembly", "gallery/thirty_grains_mpm.prm", {"Contact/Friction=0.3"}, 12);
  compare(
      "pressed", "gallery/thirty_grains_mpm.prm",
      {"Walls/top/Drive=pressure", "Walls/top/Velocity=0", "Walls/top/Pressure=1e4", "Contact/Friction=0.3"},
      12);
  compare("pressed, in balance", "gallery/thirty_grains_quasi_static_mpm.prm",
          {"Packing/Number=15", "Packing/Packing fraction=0.7", "Packing/Upper=7.2e-3, 7.2e-3",
           "Walls/top/Point=0, 7.2e-3", "Walls/right/Point=7.2e-3, 0", "Mesh/Upper=8.2e-3, 8.2e-3",
           "Walls/top/Drive=pressure", "Walls/top/Velocity=0", "Walls/top/Pressure=3e9*t",
           "Walls/right/Drive=pressure", "Walls/right/Pressure=3e9*t"},
          4);
  const Changes sticky = {"Contact/Friction of pairs=gel / bottom: 0.4; gel / gel: 0.1",
                          "Contact/Adhesion=2e3", "Contact/Adhesion range=2e-5",
                          "Contact/Adhesion of pairs=gel / left: 0"};
  Changes bonds = sticky;
  bonds.insert(bonds.end(), {"Contact/Law=bond", "Contact/Healing time=1e-4"});
  Changes cohesive = sticky;
  cohesive.push_back("Contact/Law=cohesive");
  compare("cohesion and tables", "gallery/thirty_grains_mpm.prm", cohesive, 12);
  compare("bonds", "gallery/thirty_grains_mpm.prm", bonds, 12);
  compare("obstacles", "gallery/hopper_mpm.prm",
          {"Obstacles/left_plate/Friction=0.3", "Obstacles/left_plate/Displacement=1e-3*sin(100*t); 5*t"},
          24);
  compare("ellipses", "gallery/thirty_ellipses_mpm.prm", {"Time/Scheme=moreau_jean", "Mesh/Cell size=5e-4"},
          12);
  // Grids are renewed, so that bodies are brought into the cell while friction remembers.
  compare("cell that repeats", "gallery/simple_shear_periodic.prm",
          {"Stop/End time=1", "Mesh/Cell size=4e-4", "Walls/top/Drive=pressure", "Walls/top/Pressure=1e5",
           "Walls/right/Drive=pressure", "Walls/right/Pressure=1e5", "Walls/top/Tangential velocity=-1.5",
           "Material points/Grid update=every step"},
          6);
  compare("small strain", "verification/patch_test.prm",
          {"Materials/gel/Law=linear_elastic", "Time/Time step=0.1"}, 8);
}
