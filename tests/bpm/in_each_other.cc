// SPDX-License-Identifier: LGPL-2.1-or-later
// Primaries that lie in each other, in a wall or in an obstacle, and some that go through each other in one
// step: depth, bodies and place are known.
#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;
using bpm::Overlap;

namespace
{
bpm::Primaries disks(const std::vector<std::array<double, 2>> &places,
                     const std::vector<std::array<double, 2>> &velocities)
{
  bpm::Primaries result;
  result.position = places;
  result.velocity = velocities;
  for (std::uint32_t i = 0; i < places.size(); ++i)
  {
    result.radius.push_back(1.);
    result.mass.push_back(1.);
    result.body.push_back(i);
  }
  return result;
}

void show(const std::string &what, const Overlap &found)
{
  const std::string with[] = {"body", "wall", "obstacle"};
  std::cout << what << ": ";
  if (found.depth == 0.)
    std::cout << "none\n";
  else
    std::cout << "depth " << found.depth << ", body " << found.body << " in "
              << with[static_cast<int>(found.with)] << ' ' << found.other << ", primary at " << found.place
              << '\n';
}

/// The deepest overlap of three disks of radius 1, of which the last two are of one body with @p same.
void look(const std::string &what, const std::vector<std::array<double, 2>> &places, const bool same)
{
  bpm::Primaries all = disks(places, std::vector<std::array<double, 2>>(places.size()));
  if (same)
    all.body.back() = all.body[1];
  bpm::Dynamics dynamics(all, {}, {}, bpm::DynamicsSettings());
  dynamics.detect({});
  show(what, dynamics.deepest_overlap(true));
}

void pass(const std::string &what, const std::array<double, 2> &velocity)
{
  bpm::Dynamics dynamics(disks({{0., 0.}, {5., 0.}}, {velocity, {0., 0.}}), {}, {}, bpm::DynamicsSettings());
  std::vector<Wall<2>> none;
  dynamics.detect(none);
  show(what, dynamics.step(1., none, {}).on_the_way);
}
} // namespace

int main()
{
  look("none overlap", {{0., 0.}, {5., 0.}, {9., 0.}}, false);
  look("two bodies", {{0., 0.}, {5., 0.}, {6.9, 0.}}, false);
  look("one body", {{0., 0.}, {5., 0.}, {6.9, 0.}}, true);
  look("the deeper of two", {{0., 0.}, {1.8, 0.}, {1.8, 1.9}}, false);
  pass("through the middle", {10., 0.});
  pass("off the middle", {10., 2.}); // 2 - 10/sqrt(104)
  pass("past it", {10., 5.});
  pass("not there yet", {2., 0.});
}
