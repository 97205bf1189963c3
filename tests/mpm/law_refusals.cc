// SPDX-License-Identifier: LGPL-2.1-or-later
// A law that does not admit a deformation says why: growth's in every scheme when its formula is no number,
// Gent's when its chains lock. A run that cannot go on ends with that line, not with one on points that are
// inside out.
#include "block.h"
#include "scene_of.h"

#include <softgrain/base/exceptions.h>

#include <iostream>

using namespace softgrain;

namespace
{
/// Says how a run ends in which the plates come near by up to 8 mm. @param plates_move whether there are any:
/// a body that could go through one may make no long step
void ends(const std::string &title,
          const std::string &law,
          const std::vector<std::string> &changes,
          const bool plates_move = true)
{
  std::cout << title << ": ";
  std::vector<std::string> all = {"Mesh/Lower=-12e-3, -2e-3", "Mesh/Upper=22e-3, 12e-3",
                                  "Mesh/Cell size=2.5e-3", "Stop/End time=1e-3", "Time/Time step=0"};
  all.insert(all.end(), changes.begin(), changes.end());
  if (plates_move)
    all.push_back("Walls/top/Velocity=8");
  const auto model = scene_of_text(block(law, plates_move ? plates : std::string()), all);
  try
  {
    run_until(*model, 1e-3);
    std::cout << "goes on\n";
  }
  catch (const ComputationError &error)
  {
    const std::string text = error.what();
    for (const char *word : {"locks at 'Locking' = 0.5", "is no number between", "inside out"})
      if (text.find(word) != std::string::npos)
        std::cout << word << "; ";
    std::cout << "at t = " << 1e-6 * std::floor(1e6 * model->time()) << '\n';
  }
}
} // namespace

int main()
{
  const std::string gent = "set Law = gent\nsubsection Gent\nset Locking = 0.5\nend\n",
                    growth = "set Law = growth\nsubsection Growth\nset Rate = sqrt(2.5e-4 - t)\nend\n";
  const std::vector<std::vector<std::string>> schemes = {{"Time/Scheme=quasi_static", "Time/Time step=2e-5"},
                                                         {"Time/Scheme=moreau_jean"},
                                                         {"Time/Scheme=explicit", "Time/CFL multiple=0.2"}};
  for (const auto &changes : schemes)
    ends("growth, " + changes[0], growth, changes);
  // So fast that one step goes beyond; steps may not be shorter.
  ends("gent, one long step", gent,
       {"Time/Scheme=explicit", "Time/Time step=1e-5", "Time/CFL multiple=1e6", "Time/Smallest step=1",
        "Bodies/block/Velocity=5e4*(x - 5e-3); 0"},
       false);
}
