// SPDX-License-Identifier: LGPL-2.1-or-later
// Stop conditions that cannot be met or measured are refused; the others say what they wait for.
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/shapes_2d.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>

using namespace softgrain;

namespace
{
Scene<2> box(const std::vector<std::string> &names)
{
  Scene<2> scene;
  for (const std::string &name : names)
  {
    WallDescription<2> wall;
    wall.name = name;
    const bool upright = name == "left" || name == "right";
    const double side = name == "top" || name == "right" ? -1. : 1.;
    wall.point =
        upright ? dealii::Point<2>(side < 0. ? 2. : 0., 0.) : dealii::Point<2>(0., side < 0. ? 1. : 0.);
    wall.normal[upright ? 0 : 1] = side;
    scene.walls.push_back(wall);
  }
  for (unsigned int i = 0; i < 2; ++i)
  {
    BodyDescription<2> body;
    body.name = i == 0 ? "a" : "b";
    body.shape = std::make_shared<Disk2D>(dealii::Point<2>(0.5 + i, 0.5), 0.5);
    scene.bodies.push_back(body);
  }
  return scene;
}

void look(const std::vector<std::string> &walls, const std::vector<std::pair<std::string, std::string>> &set)
{
  dealii::ParameterHandler prm;
  StopConditions::declare_parameters(prm);
  prm.enter_subsection("Stop");
  for (const auto &[key, value] : set)
    prm.set(key, value);
  prm.leave_subsection();
  try
  {
    StopConditions stop;
    stop.parse_parameters(prm);
    const Scene<2> scene = box(walls);
    stop.check(scene);
    stop.check_start(scene);
    std::cout << stop.in_words() << "; known end " << stop.end_time() << '\n';
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  const std::vector<std::string> all = {"bottom", "top", "left", "right"};
  look(all, {{"End time", "2"}, {"Axial strain", "0.3"}, {"Packing fraction", "0.9"}});
  look(all, {{"Axial strain", "0.3"}});
  look(all, {});
  look({"bottom", "left", "right"}, {{"Axial strain", "0.3"}});
  look({"bottom", "top", "left"}, {{"Packing fraction", "0.9"}});
  look({}, {{"End time", "1"}});
  look(all, {{"Packing fraction", "0.7"}}); // pi/4 of the box from the start on
}
