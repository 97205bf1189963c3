// SPDX-License-Identifier: LGPL-2.1-or-later
// The scene of a ball between two rough plates and before a smooth wall, which move as they are told.
#ifndef softgrain_tests_mpm_pushed_ball_h
#define softgrain_tests_mpm_pushed_ball_h

#include "gel.h"

#include <string>

inline std::string wall_text(const std::string &name, const std::string &lines)
{
  return "  subsection " + name + "\n" + lines + "  end\n";
}

/// A ball between plates that look along z, before a wall that looks along x. @param side 1; -1: the mirror
/// image
inline std::string pushed_ball(const std::string &of_plates, const std::string &of_stop, const int side = 1)
{
  const std::string left = side > 0 ? "-3" : "-9", right = side > 0 ? "9" : "3";
  return R"(
set Dimension = 3
subsection Mesh
  set Lower = )" +
         left + R"(, -3, -1
  set Upper = )" +
         right + R"(, 3, 6
  set Cell size = 0.8
end
subsection Time
  set Scheme = quasi_static
  set Wall way = 0.1
end
)" + softgrain::gel("0.4", "1", "1000") +
         R"(subsection Bodies
  set Names = a
  subsection a
    set Shape  = sphere
    set Center = )" +
         (side > 0 ? "" : "-") + R"(0.07, -0.11, 2.5
    set Radius = 2.5
  end
end
subsection Walls
  set Names = bottom, top, stop
)" + wall_text("bottom", "    set Friction = 0.2\n" + of_plates) +
         wall_text("top",
                   "    set Point = 0, 0, 5\n    set Velocity = t < 1 ? 0.4 : 0\n    set Friction = 0.2\n" +
                       of_plates) +
         wall_text("stop", "    set Point = " + std::string(side > 0 ? "-2.7" : "2.7") +
                               ", 0, 0\n    set Normal = " + (side > 0 ? "1" : "-1") + ", 0, 0\n" + of_stop) +
         "end\nsubsection Stop\n  set End time = 2\nend\n";
}

#endif
