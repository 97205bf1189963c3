// SPDX-License-Identifier: LGPL-2.1-or-later
// A sound scene passes; each fault put into it is named.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/scene/scene_checks.h>
#include <softgrain/scene/wall_drive.h>

#include <functional>
#include <iostream>

namespace
{
using namespace softgrain;

std::shared_ptr<const Shape<2>>
disk(const double x, const double y, const double radius, const double inner = 0.)
{
  return std::make_shared<Disk2D>(dealii::Point<2>(x, y), radius, inner);
}

Scene<2> sound_scene()
{
  Scene<2> scene;
  scene.materials.push_back({"rubber", "soft", 1000.});
  for (unsigned int i = 0; i < 2; ++i)
  {
    BodyDescription<2> body;
    body.name = i == 0 ? "a" : "b";
    body.center = dealii::Point<2>(0.5 + i, 0.5);
    body.shape = disk(0.5 + i, 0.5, 0.5);
    body.velocity = "0; -y";
    body.body_force = "X - x; t";
    scene.bodies.push_back(body);
  }
  const auto wall = [](const std::string &name, const dealii::Point<2> &point, const dealii::Point<2> &normal)
  {
    WallDescription<2> result;
    result.name = name;
    result.point = point;
    result.normal = normal;
    return result;
  };
  scene.walls = {wall("bottom", {0, 0}, {0, 1}), wall("top", {0, 1}, {0, -1}), wall("left", {0, 0}, {1, 0}),
                 wall("right", {2, 0}, {-1, 0})};
  return scene;
}

void attempt(const std::function<void(Scene<2> &)> &spoil)
{
  Scene<2> scene = sound_scene();
  try
  {
    spoil(scene);
    check_scene(scene);
    std::cout << "passed\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  attempt([](Scene<2> &) {});
  attempt([](Scene<2> &s) { s.bodies[0].shape = disk(0.5, 0.5, 0.5 * (1 + 1e-10)); });
  attempt([](Scene<2> &s) { s.bodies.clear(); });
  attempt([](Scene<2> &s) { s.bodies[0].shape = disk(0.5, 0.5, 0.); });
  attempt([](Scene<2> &s) { s.bodies[1].shape = disk(1.5, 0.5, 0.5, 0.5); });
  attempt([](Scene<2> &s) { s.bodies[0].shape = std::make_shared<Rectangle2D>(); });
  for (const Polygon &vertices :
       {Polygon(), Polygon{{0, 0}, {0.5, 0}, {1, 0}}, Polygon{{0, 0}, {1, 0}, {1, 0}, {0, 1}}})
    attempt([&vertices](Scene<2> &s) { s.bodies[0].shape = std::make_shared<Polygon2D>(vertices); });
  attempt([](Scene<2> &s) { s.bodies[0].shape = disk(0.5, 0.45, 0.5); });
  attempt([](Scene<2> &s) { s.walls[1].point[1] = 0.9; });
  attempt([](Scene<2> &s) { s.walls[0].point[1] = 1; });
  attempt(
      [](Scene<2> &s)
      {
        s.walls.resize(1);
        s.walls[0].point[1] = 5;
      });
  attempt([](Scene<2> &s) { s.bodies[1].shape = disk(1.4, 0.5, 0.5); });
  attempt([](Scene<2> &s) { s.bodies[0].velocity = "0; w"; });
  attempt([](Scene<2> &s) { s.bodies[0].body_force = "1/t; 0"; });
  attempt([](Scene<2> &s) { s.walls[1].drive = make_drive("velocity", "Walls/top", {"Velocity=0.2 t"}); });
  attempt([](Scene<2> &s) { s.walls[1].drive = make_drive("velocity", "Walls/top", {"Velocity=log(-1)"}); });
}
