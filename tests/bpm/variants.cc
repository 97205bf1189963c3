// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillings that bodies share: with two variants every other body of one size is the same, a body of another
// size is not; without, all differ; a library gives the same primaries back.
#include "bpm_scene.h"

#include <cstdio>
#include <iostream>

using namespace softgrain;

namespace
{
const std::vector<double> centers = {-60., -30., 0., 30.};

/// Places of the primaries of every body about its centre, and their radii.
std::vector<std::vector<double>> fillings(const Changes &changes)
{
  std::string text = "subsection Bodies\n  set Names = a, b, c, other\n";
  const std::string names[] = {"a", "b", "c", "other"};
  for (unsigned int i = 0; i < 4; ++i)
    text += "  subsection " + names[i] + "\n    set Center = " + std::to_string(centers[i]) +
            ", 0\n    set Radius = " + (i < 3 ? "10" : "11") + "\n  end\n";
  const auto model = bpm_scene(grain_scene(text + "end\n"), changes);
  const PointStates<2> points = model->snapshot().points;
  std::vector<std::vector<double>> result(4);
  for (std::size_t p = 0; p < points.position.size(); ++p)
    for (const double value :
         {points.position[p][0] - centers[points.body[p]], points.position[p][1], points.size[p]})
      result[points.body[p]].push_back(value);
  return result;
}

bool same(const std::vector<double> &a, const std::vector<double> &b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > 1e-12 * 60.)
      return false;
  return true;
}

void look(const std::string &what, const Changes &changes)
{
  const auto bodies = fillings(changes);
  std::cout << what << ": first and second " << (same(bodies[0], bodies[1]) ? "the same" : "different")
            << ", first and third " << (same(bodies[0], bodies[2]) ? "the same" : "different")
            << ", second and the larger one " << (same(bodies[1], bodies[3]) ? "the same" : "different")
            << '\n';
}
} // namespace

int main()
{
  look("each its own", {});
  look("two variants", {"Primaries/Variants=2"});
  look("one variant", {"Primaries/Variants=1"});
  std::remove("library.csv");
  const auto first = fillings({"Primaries/Variants=2", "Primaries/Library=library.csv"}),
             second = fillings({"Primaries/Variants=2", "Primaries/Library=library.csv"});
  std::cout << "library: " << (first == second ? "the same" : "different") << '\n';
}
