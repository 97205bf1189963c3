// SPDX-License-Identifier: LGPL-2.1-or-later
// A body that leaves the mesh ends the run with a message that names it, and the state then is whole: it can
// be saved, and a run that starts from it ends at the same place.
#include "continued.h"
#include "scene_of.h"
#include <softgrain/base/mpi_session.h>

#include <softgrain/base/exceptions.h>

#include <iostream>

using namespace softgrain;

namespace
{
std::string run_out(mpm::MpmModel &model)
{
  try
  {
    for (unsigned int i = 0; i < 1000; ++i)
      model.advance(1.);
    return "still inside";
  }
  catch (const ComputationError &error)
  {
    // The body and the place of one of its points; the body has gone a step further when a restart ends.
    const std::string message = error.what();
    return message.substr(0, message.find(" at ("));
  }
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  const std::vector<std::string> changes = {"Material points/Grid update=every step",
                                            "Bodies/left/Velocity=-20; 0"};
  const auto first = shipped_scene("gallery/two_disks.prm", changes);
  const std::string message = run_out(*first);
  const auto second = shipped_scene("gallery/two_disks.prm", changes);
  take_state(*first, *second);
  const auto x = first->snapshot().points.position, y = second->snapshot().points.position;
  double furthest = 0., leftmost = 0.;
  for (unsigned int p = 0; p < x.size(); ++p)
  {
    furthest = std::max(furthest, x[p].distance(y[p]));
    leftmost = std::min(leftmost, x[p][0]);
  }
  std::cout << message << '\n'
            << x.size() - y.size() << " points lost, " << below(1e-15, furthest)
            << " m moved by the restart\n"
            << "leftmost point at " << leftmost << " m\n"
            << (run_out(*second) == message ? "ends there again" : "does not end there again") << '\n';
}
