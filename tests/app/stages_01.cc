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
subsection Stages
  set Names = press, squeeze, release
  subsection press
    subsection Stop
      set End time = 3e-4
    end
    subsection top
      set Drive    = pressure
      set Pressure = 1e9*t
    end
  end
  subsection squeeze
    subsection Stop
      set Axial strain = 0.02
    end
    subsection top
      set Drive    = position
      set Position = 0.5*t
    end
  end
  subsection release
    subsection Stop
      set End time = 2e-4
    end
    subsection top
      set Drive    = pressure
      set Pressure = 1e5
    end
  end
end
)";

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

int main(int argc, char **argv)
{
  using namespace softgrain;
  const softgrain::MPISession mpi(argc, argv);
  write_text("scene.prm", scene);
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
  // Without inertia every step ends in balance, so a stage that waits for it is over after the first.
  softgrain_command({"run", "scene.prm", "--output", "balanced", "--set",
                     "Stages/press/Stop/Equilibrium=0.01", "--set", "Stop/End time=2e-4"});
  std::cout << "until balance\n";
  print("balanced");
}
