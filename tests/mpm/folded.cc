// SPDX-License-Identifier: LGPL-2.1-or-later
// A clamp that is pressed until its arms meet: a body against itself. The arms carry force, lie in each other
// by less than a tenth of a cell, and the balance of energy holds, at rest and moving, with every scheme,
// with friction and without. What the arms do to each other is no contact between bodies. The mirror image of
// the scene gives the same force.
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;

const std::string clamp = R"(
subsection Mesh
  set Lower     = -9e-3, -4.5e-3
  set Upper     = 21e-3, 18e-3
  set Cell size = 7.5e-4
end
)" + gel("0.3") + R"(subsection Bodies
  set Names = clamp
  subsection clamp
    set Shape    = polygon
    set Vertices = 0,0; 12e-3,0; 12e-3,5.25e-3; 3e-3,5.25e-3; 3e-3,6.75e-3; 12e-3,6.75e-3; 12e-3,12e-3; 0,12e-3
  end
end
subsection Walls
  set Names = bottom, top
  subsection top
    set Point = 0, 12e-3
    set Velocity = 1
  end
end
subsection Stop
  set End time = 1
end
)";
const std::string mirrored = "Bodies/clamp/Vertices=12e-3,0; 12e-3,12e-3; 0,12e-3; 0,6.75e-3; 9e-3,6.75e-3; "
                             "9e-3,5.25e-3; 0,5.25e-3; 0,0";

struct Result
{
  double force = 0, between_arms = 0, overlap = 0, energy = 0, coordination = 0;
};

Result press(Changes changes)
{
  const auto model = scene_of_text(clamp, changes);
  EnergyWatch energy(*model);
  Result result;
  run_until(*model, 2.4e-3,
            [&](const StepReport &report)
            {
              energy.look(*model);
              result.overlap = std::max(result.overlap, report.max_penetration / 7.5e-4);
            });
  result.force = model->walls()[1].normal_force;
  for (const ContactState<2> &contact : model->snapshot().contacts)
    if (contact.body_a == contact.body_b)
      result.between_arms += contact.force.norm();
  result.energy = energy.error();
  result.coordination = model->coordination();
  return result;
}

void show(const std::string &what, Changes changes)
{
  const Result one = press(changes);
  changes.push_back(mirrored);
  const Result other = press(changes);
  std::cout << what << ": force " << one.force << " N/m, between the arms " << one.between_arms
            << " N/m, overlap " << below(0.1, one.overlap) << " cells, energy off by "
            << below(0.02, one.energy) << ", coordination " << one.coordination << ", mirrored "
            << below(1e-6, other.force / one.force - 1.) << '\n';
}
} // namespace

int main()
{
  const Changes rest = {"Time/Scheme=quasi_static", "Time/Time step=1e-4"},
                explicit_steps = {"Time/Scheme=explicit", "Time/CFL multiple=0.5"};
  const std::string friction = "Contact/Friction=0.5";
  const auto with = [](Changes changes, const std::string &one)
  {
    changes.push_back(one);
    return changes;
  };
  show("at rest", rest);
  show("at rest, friction", with(rest, friction));
  show("moving", {"Time/CFL multiple=20"});
  show("moving, friction", {"Time/CFL multiple=20", friction});
  show("explicit", explicit_steps);
  show("explicit, friction", with(explicit_steps, friction));
}
