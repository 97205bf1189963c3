// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls that lie under their weight without inertia. One on a floor, also when it begins a little above it:
// the floor bears its weight, and it sinks in as Hertz says. Three in a slot, two on the floor and one
// between them: floor and sides bear what statics asks for. What gravity does is stored or lost. A load that
// sees velocities is refused.
#include "gel.h"
#include "space_model_of.h"

#include <softgrain/base/exceptions.h>

#include <iostream>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
constexpr double radius = 2., density = 1., gravity = 2e-4;

std::string scene_of(const std::vector<std::string> &centers, const std::string &walls)
{
  std::string names, bodies;
  for (unsigned int b = 0; b < centers.size(); ++b)
  {
    const std::string name(1, 'a' + b);
    names += (b > 0 ? ", " : "") + name;
    bodies += "  subsection " + name +
              "\n    set Shape = sphere\n    set Radius = 2\n    set Center = " + centers[b] + "\n  end\n";
  }
  return R"(
set Dimension = 3
subsection Mesh
  set Lower = -8, -8, -8
  set Upper = 8, 8, 12
  set Cell size = 0.65
end
subsection Time
  set Scheme = quasi_static
  set Time step = 1
end
subsection Loads
  set Gravity = 0, 0, -2e-4
end
)" + gel("0.3", "1", "1") +
         "subsection Bodies\n  set Names = " + names + "\n" + bodies + "end\n" + walls +
         "subsection Stop\n  set End time = 1\nend\n";
}

const std::string
    ground = "subsection Walls\n  set Names = bottom\n  subsection bottom\n    set Point = 0, 0, 0\n  "
             "end\nend\n",
    slot = R"(subsection Walls
  set Names = bottom, left, right, front, back
  subsection bottom
    set Point = 0, 0, 0
  end
  subsection left
    set Point = -4.4, 0, 0
  end
  subsection right
    set Point = 4.4, 0, 0
  end
  subsection front
    set Point = 0, -2, 0
  end
  subsection back
    set Point = 0, 2, 0
  end
end
)";

std::unique_ptr<Model<3>> model_of_text(const std::string &text, const std::vector<std::string> &changes = {})
{
  std::ofstream("scene.prm") << text;
  return model_of("scene.prm", changes);
}

std::unique_ptr<Model<3>> rested(std::unique_ptr<Model<3>> model)
{
  StepReport report = model->advance(1.);
  model->settle(report);
  return model;
}

/// Of the work of a weight that comes at once two fifths are stored in a contact of Hertz's.
void one()
{
  const double weight = density * gravity * 4. / 3. * dealii::numbers::PI * radius * radius * radius,
               modulus = 1. / (1. - 0.3 * 0.3),
               sinks = std::cbrt(9. * weight * weight / (16. * radius * modulus * modulus));
  for (const double above : {0., 0.1})
  {
    std::ostringstream center;
    center << "0.1, -0.2, " << radius + above;
    auto hung = model_of_text(scene_of({center.str()}, ground));
    const double begun = hung->snapshot().bodies[0].center[2];
    const auto model = rested(std::move(hung));
    const double sunk = begun - model->snapshot().bodies[0].center[2];
    std::cout << above << " above the floor: floor over weight off by "
              << below(1e-4, model->walls()[0].normal_force / weight - 1.) << ", sinks by "
              << (sunk - above) / sinks << " of Hertz's way, stored of the weight times that "
              << model->energies().elastic / (weight * (sunk - above)) << '\n';
    for (const auto &[name, work] : model->works())
      if (name == "gravity_work_J")
        std::cout << "  work of gravity over weight times way off by "
                  << below(1e-12, work / (weight * sunk) - 1.) << '\n';
  }
}

void three()
{
  const double weight = density * gravity * 4. / 3. * dealii::numbers::PI * radius * radius * radius;
  // Centres of the lower two are 4.8 apart, and those of neighbours 4.
  const double along = 2.4, up = std::sqrt(16. - along * along);
  std::ostringstream top;
  top.precision(15);
  top << "0, 0, " << radius + up;
  const auto model = rested(model_of_text(scene_of({"-2.4, 0, 2", "2.4, 0, 2", top.str()}, slot)));
  const auto walls = model->walls();
  std::cout << "three: floor over weights off by " << below(1e-3, walls[0].normal_force / (3. * weight) - 1.)
            << ", sides over " << walls[1].normal_force / (0.5 * weight * along / up) << ' '
            << walls[2].normal_force / (0.5 * weight * along / up) << " of statics, coordination "
            << model->coordination() << ", stored of the work "
            << model->energies().elastic / model->energies().external_work << '\n';
}
} // namespace

int main()
{
  one();
  three();
  try
  {
    model_of_text(scene_of({"0, 0, 2"}, ground), {"Loads/Drag/Rate=1"});
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
