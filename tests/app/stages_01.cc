// SPDX-License-Identifier: LGPL-2.1-or-later
// A path of stages, with real models: one disk is pressed, then squeezed by a wall that goes on, then let go.
// Each stage ends where it says; a run that was stopped within a stage, and one that goes on from the end of
// a stage, leave the same history.
#include "mpm/gel.h"
#include "stub_model.h"
#include <softgrain/base/mpi_session.h>

#include <algorithm>

namespace
{
const std::string scene = R"(
subsection Mesh
  set Lower     = -8e-3, -2e-3
  set Upper     = 8e-3, 12e-3
  set Cell size = 1e-3
end
)" + softgrain::gel("0.45") +
                          R"(subsection Bodies
  set Names = disk
  subsection disk
    set Center = 0, 5e-3
    set Radius = 5e-3
  end
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 1e-4
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point = 0, 10e-3
  end
  subsection left
    set Point = -8e-3, 0
  end
  subsection right
    set Point = 8e-3, 0
  end
end
)";

/// A stage that ends as one parameter says, in which the upper wall is driven as another says.
std::string
stage(const std::string &name, const std::string &end, const std::string &drive, const std::string &how)
{
  return "subsection " + name + "\n subsection Stop\n set " + end +
         "\n end\n subsection top\n set Drive = " + drive + "\n set " + how + "\n end\n end\n";
}

const std::string press = stage("press", "End time = 3e-4", "pressure", "Pressure = 1e9*t"),
                  squeeze = stage("squeeze", "Axial strain = 0.02", "position", "Position = 0.5*t"),
                  release = stage("release", "End time = 2e-4", "pressure", "Pressure = 1e5"),
                  back = stage("back", "End time = 2e-4", "velocity", "Velocity = -0.3");

std::string path_of(const std::string &names, const std::string &stages)
{
  return scene + "subsection Stages\n set Names = " + names + "\n" + stages + "end\n";
}

std::string content(const std::string &path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The columns that matter, row by row.
void print(const std::string &directory)
{
  std::istringstream lines(content(directory + "/history.csv"));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(cell);
    if (names.empty())
    {
      names = row;
      continue;
    }
    const auto value = [&](const std::string &name)
    { return row[std::find(names.begin(), names.end(), name) - names.begin()]; };
    std::cout << "  t " << value("time_s") << ", stage " << value("stage") << ", top at "
              << value("top_position_m") << ", pressure " << std::stod(value("top_force_N_per_m")) / 16e-3
              << '\n';
  }
}

const char *same(const std::string &a, const std::string &b)
{
  return content(a + "/history.csv") == content(b + "/history.csv") ? "the same" : "another";
}
} // namespace

int main(int, char **argv)
{
  using namespace softgrain;
  const softgrain::MPISession mpi(argv);
  write_text("scene.prm", path_of("press, squeeze, release", press + squeeze + release));
  softgrain_command({"run", "scene.prm", "--output", "whole"});
  print("whole");
  // Stopped within the second stage, by a condition that changes no step.
  softgrain_command({"run", "scene.prm", "--output", "parts", "--set", "Stop/Axial strain=0.11"});
  const std::string begun = content("parts/history.csv");
  softgrain_command({"run", "scene.prm", "--output", "parts", "--restart", "--set", "Stop/Axial strain=0"});
  std::cout << "in parts, " << std::count(begun.begin(), begun.end(), '\n') - 2 << " steps first: history "
            << same("whole", "parts") << '\n';
  softgrain_command({"run", "scene.prm", "--output", "parts", "--restart", "parts/stage-press.h5"});
  std::cout << "from the end of a stage: history " << same("whole", "parts") << '\n';
  // Once prepared, several ways on: what comes after a stage may be another than it was when that ended.
  write_text("other.prm", path_of("press, back", press + back));
  softgrain_command({"run", "other.prm", "--output", "straight"});
  softgrain_command({"run", "other.prm", "--output", "parts", "--restart", "parts/stage-press.h5"});
  std::cout << "another stage after the first: history " << same("straight", "parts") << '\n';
  softgrain_command({"run", "other.prm", "--output", "branch", "--restart", "parts/stage-press.h5"});
  std::cout << "in a folder of its own\n";
  print("branch");
  const int code = softgrain_command({"run", "other.prm", "--output", "parts", "--restart",
                                      "parts/stage-press.h5", "--set", "Stages/press/top/Pressure=2e9*t"});
  std::cout << "another first stage: exit code " << code << '\n';
  // A run that has come to its end goes on with a stage that is put behind its last one.
  write_text("two.prm", path_of("press, squeeze", press + squeeze));
  softgrain_command({"run", "two.prm", "--output", "longer"});
  softgrain_command({"run", "scene.prm", "--output", "longer", "--restart"});
  std::cout << "one stage more after the end: history " << same("whole", "longer") << '\n';
  // Without inertia every step ends in balance, so a stage that waits for it is over after the first.
  softgrain_command({"run", "scene.prm", "--output", "balanced", "--set",
                     "Stages/press/Stop/Equilibrium=0.01", "--set", "Stop/End time=2e-4"});
  std::cout << "until balance\n";
  print("balanced");
}
