// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_bpm_space_scene_h
#define softgrain_tests_bpm_space_scene_h

// Tests of bonded particles in space: small scenes in units near 1.
#include "bpm_scene.h"

#include <softgrain/bpm/space_model.h>

namespace softgrain
{
/// The model of a parameter file given as text, changed by "Section/Key=value".
inline std::unique_ptr<bpm::SpaceModel> space_scene(const std::string &text, Changes changes = {})
{
  std::ofstream("scene.prm") << "set Model = bpm\nset Dimension = 3\n" << text;
  changes.insert(changes.begin(), "Output directory=results");
  Input input("scene.prm", changes);
  return std::unique_ptr<bpm::SpaceModel>(
      dynamic_cast<bpm::SpaceModel *>(input.create_model_in_space().release()));
}

/// A section `Bodies` with balls of these centres, velocities and angular velocities.
struct Ball
{
  std::string center, velocity = "0; 0; 0", spin = "0, 0, 0";
};
inline std::string balls(const std::vector<Ball> &all, const std::string &radius)
{
  std::ostringstream text;
  text << "subsection Bodies\n  set Names = ";
  for (std::size_t i = 0; i < all.size(); ++i)
    text << (i > 0 ? ", " : "") << "b" << i;
  for (std::size_t i = 0; i < all.size(); ++i)
    text << "\n  subsection b" << i << "\n    set Shape = sphere\n    set Center = " << all[i].center
         << "\n    set Radius = " << radius << "\n    set Velocity = " << all[i].velocity
         << "\n    set Angular velocity = " << all[i].spin << "\n  end";
  text << "\nend\n";
  return text.str();
}

/// A box of walls from 0 to these edges, the top of which comes down.
inline std::string box(const std::string &edge, const std::string &speed)
{
  const std::string far[] = {edge + ", 0, 0", "0, " + edge + ", 0", "0, 0, " + edge};
  return R"(subsection Walls
  set Names = left, right, front, back, bottom, top
  subsection left
    set Point = 0, 0, 0
  end
  subsection right
    set Point = )" +
         far[0] + R"(
  end
  subsection front
    set Point = 0, 0, 0
  end
  subsection back
    set Point = )" +
         far[1] + R"(
  end
  subsection bottom
    set Point = 0, 0, 0
  end
  subsection top
    set Point = )" +
         far[2] + R"(
    set Velocity = )" +
         speed + R"(
  end
end
)";
}
} // namespace softgrain

#endif
