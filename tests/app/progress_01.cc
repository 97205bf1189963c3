// SPDX-License-Identifier: LGPL-2.1-or-later
// Per cent of a run whose stages last 0.1 s and, until the strain of the whole run is 0.1, 1 - exp(-0.1) -
// 0.1 s more: wherever it is stopped, they are about those of the time that it takes, 0.0952 s a hundredth.
// The same goes for a run that goes on from a checkpoint.
#include "stub_model.h"
#include <softgrain/base/mpi_session.h>

#include <cmath>
#include <regex>

namespace
{
/// The last per cent in run.log.
double per_cent(const std::string &directory)
{
  std::ostringstream text;
  text << std::ifstream(directory + "/run.log").rdbuf();
  const std::string log = text.str();
  const std::regex pattern("residual \\S+ +([0-9.]+) %");
  double last = -1.;
  for (std::sregex_iterator found(log.begin(), log.end(), pattern); found != std::sregex_iterator(); ++found)
    last = std::stod((*found)[1]);
  return last;
}
} // namespace

int main(int, char **argv)
{
  using namespace softgrain;
  const softgrain::MPISession mpi(argv);
  write_text("scene.prm", std::string(stub_scene) +
                              "subsection Stages\n set Names = first, last\n subsection first\n"
                              "  subsection Stop\n set End time = 0.1\n end\n end\nend\n");
  const double whole = 10. * (1. - std::exp(-0.1)); // of a wall at 0.1 m/s, 1 m above the other
  const auto show = [&](const std::string &directory, const int step)
  {
    const double error = per_cent(directory) - 100. * 0.01 * step / whole;
    std::cout << "after step " << step << (std::abs(error) < 2. ? ": right" : ": wrong by ");
    if (!(std::abs(error) < 2.))
      std::cout << error << " %";
    std::cout << '\n';
  };
  for (const int step : {5, 15, 33, 60, 90})
  {
    softgrain_command({"run", "scene.prm", "--output", "strain", "--overwrite", "--set", "Stop/End time=0",
                       "--set", "Stop/Axial strain=0.1", "--set",
                       "Stub/Stopped at step=" + std::to_string(step)});
    show("strain", step);
  }
  softgrain_command({"run", "scene.prm", "--output", "strain", "--overwrite", "--set", "Stop/End time=0",
                     "--set", "Stop/Axial strain=0.1", "--set", "Stub/Stopped at step=30"});
  softgrain_command({"run", "scene.prm", "--output", "strain", "--restart", "--set", "Stop/End time=0",
                     "--set", "Stop/Axial strain=0.1", "--set", "Stub/Stopped at step=60"});
  std::cout << "going on, ";
  show("strain", 60);
  softgrain_command({"run", "scene.prm", "--output", "strain", "--restart", "--set", "Stop/End time=0",
                     "--set", "Stop/Axial strain=0.1"});
  std::cout << "at the end: " << per_cent("strain") << " %\n";
  // A limit of time far away does not count beside the strain.
  softgrain_command({"run", "scene.prm", "--output", "both", "--set", "Stop/End time=1000", "--set",
                     "Stop/Axial strain=0.1", "--set", "Stub/Stopped at step=60"});
  std::cout << "with a late end, ";
  show("both", 60);
}
