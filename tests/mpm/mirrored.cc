// SPDX-License-Identifier: LGPL-2.1-or-later
// A disk that a wall presses past the corner of a rectangle, which lies on another wall, without inertia,
// between two walls at their sides, and the mirror image of that: rays stand alike, though outlines run the
// other way round and begin elsewhere. Corners belong to two sides, and all places of a side along a wall are
// nearest to it. Both touch the walls at their sides but lightly, where rounding moves them by 1e-5 cells.
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double cell = 1e-3;

/// What it says of x is true of @p sign times x.
std::string scene(const double sign)
{
  const auto in = [](const std::string &name, const std::string &text)
  { return "subsection " + name + '\n' + text + "end\n"; };
  const auto set = [](const std::string &name, const std::string &value)
  { return "set " + name + " = " + value + '\n'; };
  const auto at = [&](const std::string &name, const double x, const double y)
  { return set(name, std::to_string(sign * x) + ", " + std::to_string(y)); };
  const double left = sign > 0. ? 0.00581 : 0.00533, right = 0.01114 - left;
  return gel("0.3") +
         in("Mesh", set("Lower", "-15e-3, -2e-3") + set("Upper", "15e-3, 18e-3") + set("Cell size", "1e-3")) +
         in("Bodies", set("Names", "block, disk") +
                          in("block", set("Shape", "rectangle") + set("Size", "7.3e-3, 4e-3") +
                                          at("Center", -0.00213, 0.002)) +
                          in("disk", set("Radius", "4e-3") + at("Center", 0.0013, 0.0081))) +
         in("Walls", set("Names", "bottom, top, left, right") + in("bottom", set("Point", "0, 0")) +
                         in("top", set("Point", "0, 12.2e-3") + set("Velocity", "1e-3")) +
                         in("left", set("Point", std::to_string(-left) + ", 0")) +
                         in("right", set("Point", std::to_string(right) + ", 0"))) +
         in("Contact", set("Friction", "0.5")) + in("Newton", set("Residual tolerance", "1e-9")) +
         in("Time", set("Scheme", "quasi_static") + set("Time step", "0.2")) +
         in("Stop", set("End time", "1"));
}

std::vector<dealii::Point<2>> centers(const double sign)
{
  const auto model = scene_of_text(scene(sign));
  run_until(*model, 0.8);
  std::vector<dealii::Point<2>> places;
  for (const auto &body : model->bodies())
    places.push_back(body.center());
  return places;
}
} // namespace

int main()
{
  const std::vector<dealii::Point<2>> here = centers(1.), there = centers(-1.);
  const double before[] = {-0.00213, 0.0013};
  for (unsigned int b = 0; b < here.size(); ++b)
    std::cout << "body " << b << " has moved by " << (here[b][0] - before[b]) / cell
              << " cells, its image is off by "
              << below(1e-4, std::hypot(here[b][0] + there[b][0], here[b][1] - there[b][1]) / cell) << '\n';
}
