// SPDX-License-Identifier: LGPL-2.1-or-later
// A block of bonded primaries on an incline of tan(angle) = 0.2 whose friction is 0.5: with rolling
// resistance it stands still, without it slides nearly as without friction, and that is warned of. The block
// is heavy: of 48 random ones two thirds stand within 0.02, others settle by up to 0.4; without rolling
// resistance all slide by more than 0.97.
#include "bpm_scene.h"

#include <softgrain/app/outlook.h>

#include <iostream>

using namespace softgrain;

namespace
{
const std::string block = grain_scene(R"(
subsection Bodies
  set Names = block
  subsection block
    set Shape  = rectangle
    set Center = 0, 9
    set Size   = 24, 16
  end
end
subsection Walls
  set Names = floor
  subsection floor
    set Point    = 0, 0.9
    set Normal   = 0, 1
    set Friction = 0.5
  end
end
subsection Loads
  set Gravity = 1e-3, -5e-3
end
subsection Primaries
  set Seed = 12
end
)");

/// How far the block comes from the time 40 on, when it has settled, to 100, over the way without any
/// friction.
double way(const Changes &changes)
{
  const auto model = bpm_scene(block, changes);
  const auto place_at = [&model](const double time)
  {
    while (model->time() < time)
      model->advance(time - model->time());
    return model->snapshot().bodies[0].center[0];
  };
  const double begin = place_at(40.);
  return (place_at(100.) - begin) / (0.5 * 1e-3 * (100. * 100. - 40. * 40.));
}

bool warns(Changes changes)
{
  changes.insert(changes.begin(), "Output directory=results");
  Input input("scene.prm", changes);
  const std::optional<RunOutline> outline = outline_of(input);
  const std::optional<Forecast> forecast = input.estimates().forecast(*outline);
  for (const std::string &warning : forecast->warnings)
    if (warning.find("Rolling resistance") != std::string::npos)
      return true;
  return false;
}
} // namespace

int main()
{
  const Changes held = {"Contact/Rolling resistance=1", "Contact/Inner rolling resistance=1"};
  const double free = way({}), still = way(held);
  std::cout << "without rolling resistance " << (free > 0.7 ? "it slides" : "it is held") << ", with it "
            << (std::abs(still) < 0.02 ? "it stands" : "IT SLIDES") << '\n';
  std::cout << "warned of: " << warns({}) << ", with rolling resistance " << warns(held)
            << ", without friction " << warns({"Walls/floor/Friction=0"}) << ", disks alone "
            << warns({"Primaries/Number per body=1"}) << '\n';
}
