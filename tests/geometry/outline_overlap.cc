// SPDX-License-Identifier: LGPL-2.1-or-later
// How deep outlines lie in each other: known from their sizes, and the same when the two change places, and
// for the mirror image.
#include <softgrain/geometry/outline_overlap.h>

#include <cmath>
#include <iostream>

using namespace softgrain;
using Place = dealii::Point<2>;

/// Loops, with what an Outline refers to.
struct Loops
{
  explicit Loops(const std::vector<Polygon> &loops, const bool mirrored = false)
  {
    for (const Polygon &loop : loops)
    {
      for (const Place &x : loop)
        vertices.push_back(mirrored ? Place(-x[0], x[1]) : x);
      start.push_back(vertices.size());
    }
  }
  Outline outline() const { return {vertices, start, dealii::BoundingBox<2>(vertices)}; }

  std::vector<Place> vertices;
  std::vector<unsigned int> start{0};
};

std::vector<Polygon> disk(const double x, const double y, const double radius)
{
  return {circle({x, y}, radius, 2e-3 * radius, false)};
}

std::vector<Polygon> ring(const double radius, const double inner)
{
  return {circle({0., 0.}, radius, 2e-3 * radius, false), circle({0., 0.}, inner, 2e-3 * inner, true)};
}

std::vector<Polygon> rectangle(const double x, const double y, const double to_x, const double to_y)
{
  return {{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}}};
}

void show(const std::string &what, const std::vector<Polygon> &a, const std::vector<Polygon> &b)
{
  const Loops one(a), other(b), mirror(a, true), mirror_other(b, true);
  const Intrusion found = deepest_intrusion(one.outline(), other.outline()),
                  swapped = deepest_intrusion(other.outline(), one.outline()),
                  mirrored = deepest_intrusion(mirror.outline(), mirror_other.outline());
  std::cout << what << ": " << found.depth << ", swapped " << swapped.depth - found.depth << ", mirrored "
            << mirrored.depth - found.depth << '\n';
}

int main()
{
  show("two disks that overlap by 0.1", disk(0., 0., 1.), disk(1.9, 0., 1.));
  show("apart by 0.1, boxes meet", disk(0., 0., 1.), disk(1.49, 1.49, 1.));
  show("a small one, 0.3 within a large one", disk(0., 0., 10.), disk(9.8, 0., 0.1));
  show("the smallest in the largest", disk(0., 0., 1000.), disk(999.5, 0., 1e-3));
  show("a disk in the hole of a ring", ring(1., 0.7), disk(0.1, 0., 0.3));
  show("that has come 0.05 into the ring", ring(1., 0.7), disk(0.45, 0., 0.3));
  show("half way through the ring", ring(1., 0.7), disk(0.85, 0., 0.3));
  // So small that its vertices, whichever lies deepest, tell the depth to the tolerance.
  show("a disk in the material of a ring", ring(1., 0.5), disk(0.75, 0., 0.02));
  show("the tip of a triangle in a side", rectangle(0., 0., 1., 1.), {{{0.5, 0.98}, {0.8, 2.}, {0.2, 2.}}});
  show("a plus of two strips", rectangle(-2., -0.1, 2., 0.1), rectangle(-0.2, -2., 0.2, 2.));
  show("sides that share a line", rectangle(0., 0., 1., 1.), rectangle(1., 0., 2., 1.));
  show("one pushed into another along that line", rectangle(0., 0., 1., 1.), rectangle(0.9, 0., 1.9, 1.));
  const double c = std::sqrt(0.5);
  const Loops round(disk(0., 0., 1.)), hollow(ring(1., 0.7));
  std::cout << "beyond a wall by 0.2: "
            << deepest_beyond(round.outline(), Place(-0.8 * c, -0.8 * c), Place(c, c)).depth << '\n'
            << "not beyond: " << deepest_beyond(round.outline(), Place(-1.01, 0.), Place(1., 0.)).depth
            << '\n'
            << "wholly beyond: " << deepest_beyond(round.outline(), Place(3., 0.), Place(1., 0.)).depth
            << '\n'
            << "a line that is 0.15 within: "
            << deepest_within(round.outline(), {{-5., 0.85}, {5., 0.85}}, 1e-3).depth << '\n'
            << "its end 0.4 within: " << deepest_within(round.outline(), {{0.6, 0.}, {5., 0.}}, 1e-3).depth
            << '\n'
            << "in the hole: " << deepest_within(hollow.outline(), {{-0.6, 0.}, {0.6, 0.}}, 1e-3).depth
            << '\n'
            << "its end amid the material of 0.3: "
            << deepest_within(hollow.outline(), {{0., 0.}, {0.85, 0.}}, 1e-3).depth << '\n';
}
