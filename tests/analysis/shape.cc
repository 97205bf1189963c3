// SPDX-License-Identifier: LGPL-2.1-or-later
// Ellipses and rectangles of known axes, alike and crossed; a disk, a frame with its hole, and one far away.
#include "configurations.h"

using namespace configurations;

int main()
{
  std::cout.precision(12);
  std::cout << "ellipses 2:1 at 30 degrees\n";
  Snapshot<2> snapshot;
  for (const double x : {0., 5., 1e4})
    add_ellipse(snapshot, {x, x}, 2, 1, M_PI / 6);
  print(snapshot, {"shape"});

  std::cout << "and as many across: no orientation\n";
  for (const double x : {10., 15., 20.})
    add_ellipse(snapshot, {x, 0}, 2, 1, -M_PI / 3);
  snapshot.bodies.pop_back();
  add_ellipse(snapshot, {20, 0}, 2, 1, 2 * M_PI / 3);
  print(snapshot, {"shape"});

  std::cout << "a rectangle 3:1, upright\n";
  Snapshot<2> rectangle;
  add_body(rectangle, {0.5, 1.5}, {{{0, 0}, {1, 0}, {1, 3}, {0, 3}}}, 3);
  print(rectangle, {"shape"});

  // A frame 6:4 that lies: half the bodies each way.
  std::cout << "and a frame\n";
  add_body(rectangle, {5, 0}, {{{2, -2}, {8, -2}, {8, 2}, {2, 2}}, {{3, 1}, {7, 1}, {7, -1}, {3, -1}}}, 16);
  print(rectangle, {"shape"});

  std::cout << "a disk has no strain\n";
  Snapshot<2> disk;
  add_ellipse(disk, {1, 1}, 1, 1, 0);
  const auto values = MeasureSet({"shape"}).evaluate(disk);
  std::cout << (std::abs(*values[0].second - 1) < 1e-9 && std::abs(*values[3].second) < 1e-9 ? "yes" : "no")
            << '\n';
}
