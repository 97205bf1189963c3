// SPDX-License-Identifier: LGPL-2.1-or-later
// A step that is refused leaves nothing behind: the shorter one that follows it is that of a model which was
// asked for no more, bit for bit, with walls whose pressure depends on what they felt before.
#include "gel.h"
#include "scene_of.h"

#include <softgrain/base/mpi_session.h>

#include <iostream>

using namespace softgrain;

namespace
{
const std::string scene = R"(
subsection Mesh
  set Lower     = -7e-3, -7e-3
  set Upper     = 7e-3, 7e-3
  set Cell size = 1e-3
end
)" + gel("0.3") + R"(subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 5e-3
  end
end
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, -5e-3
  end
  subsection top
    set Point    = 0, 5e-3
    set Velocity = 10
  end
  subsection left
    set Point = -5e-3, 0
  end
  subsection right
    set Point = 5e-3, 0
  end
end
subsection Time
  set Time step = 1e-4
end
subsection Stop
  set End time = 1
end
)";

std::string state(const mpm::MpmModel &model)
{
  std::ostringstream text;
  text << std::hexfloat << model.time();
  for (const auto &body : model.bodies())
    text << ' ' << body.velocity.sum() << ' ' << body.displacement.squaredNorm();
  for (const auto &wall : model.walls())
    text << ' ' << wall.position << ' ' << wall.velocity << ' ' << wall.normal_force;
  return text.str();
}

void refuse(const std::string &what, const std::vector<std::string> &changes)
{
  const auto bold = scene_of_text(scene, changes), careful = scene_of_text(scene, changes);
  const StepReport report = bold->advance(1.);
  careful->advance(report.dt);
  std::cout << what << ": refused before " << (report.attempts > 0 ? "yes" : "no") << ", then "
            << (state(*bold) == state(*careful) ? "the same" : "another") << " step\n";
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  const std::string strain = "Newton/Largest strain=0.02";
  refuse("prescribed", {strain});
  refuse("pressure", {strain, "Walls/right/Drive=pressure", "Walls/right/Pressure=1e5"});
  refuse("mean pressure", {strain, "Walls/right/Drive=mean_pressure", "Walls/right/Mean pressure=1e5"});
}
