// SPDX-License-Identifier: LGPL-2.1-or-later
// How deep an outline lies in itself: nothing where it only bends, is hollow or has a notch; known from sizes
// where the arms of a C have come through each other, and where a part is turned inside out, unless that is
// small. The mirror image has the same.
#include <softgrain/geometry/outline_overlap.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain;
using Place = dealii::Point<2>;

/// A polygon with its sides in parts no longer than @p part.
Polygon drawn(const Polygon &corners, const double part)
{
  Polygon line;
  for (unsigned int i = 0; i < corners.size(); ++i)
  {
    const Place &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const unsigned int n = std::max(1., std::ceil(a.distance(b) / part));
    for (unsigned int k = 0; k < n; ++k)
      line.push_back(a + static_cast<double>(k) / n * (b - a));
  }
  return line;
}

constexpr double least_way = 0.5;

double depth_of(const std::vector<Polygon> &loops, const bool mirrored)
{
  Polygon vertices;
  std::vector<unsigned int> start{0};
  for (Polygon loop : loops)
  {
    if (mirrored)
    {
      for (Place &x : loop)
        x[0] *= -1.;
      std::reverse(loop.begin(), loop.end());
    }
    vertices.insert(vertices.end(), loop.begin(), loop.end());
    start.push_back(vertices.size());
  }
  return deepest_fold(Outline(vertices, start, dealii::BoundingBox<2>(vertices)), least_way).depth;
}

void show(const std::string &what, const std::vector<Polygon> &loops)
{
  const double depth = depth_of(loops, false), mirrored = depth_of(loops, true);
  std::cout << what << ": " << depth << ", mirrored " << std::abs(mirrored - depth) << '\n';
}

/// A C that opens to the right: its notch ends at half of its height, its lips are so far apart.
Polygon clamp(const double apart)
{
  return drawn(
      {{0., 0.}, {4., 0.}, {4., 1. - 0.5 * apart}, {1., 1.}, {4., 1. + 0.5 * apart}, {4., 2.}, {0., 2.}},
      0.05);
}

/// r = share + cos(angle): a loop within, of matter that is turned inside out, where the share is below 1.
Polygon snail(const double share)
{
  Polygon line;
  for (unsigned int i = 0; i < 400; ++i)
  {
    const double angle = 2. * M_PI * i / 400, r = share + std::cos(angle);
    line.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return line;
}

int main()
{
  const Polygon outer = circle({0., 0.}, 1., 1e-3, false), hole = circle({0., 0.}, 0.7, 1e-3, true);
  show("disk", {outer});
  show("ring", {outer, hole});
  show("C that is open", {clamp(0.2)});
  show("C whose lips have come 0.2 through each other", {clamp(-0.2)});
  show("the same with its beginning in the notch", {[]()
                                                    {
                                                      Polygon line = clamp(-0.2);
                                                      std::rotate(line.begin(),
                                                                  line.begin() + line.size() / 2, line.end());
                                                      return line;
                                                    }()});
  show("snail without a loop", {snail(1.2)});
  show("snail with a loop 0.5 long", {snail(0.5)});
  show("snail with a loop 0.1 long, which is too small to count", {snail(0.9)});
}
