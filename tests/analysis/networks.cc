// SPDX-License-Identifier: LGPL-2.1-or-later
// Networks whose contacts, rattlers and pores can be counted: a hexagon around a disk, a ring of five, chains
// that hang on nothing, and two clusters side by side.
#include "configurations.h"

using namespace configurations;

namespace
{
/// A ring of @p n disks around @p center that touch, each its next.
void add_ring(Snapshot<2> &snapshot, const Point &center, const unsigned int n)
{
  const unsigned int first = snapshot.bodies.size();
  const double radius = 1. / std::sin(M_PI / n);
  for (unsigned int i = 0; i < n; ++i)
    add_ellipse(snapshot, center + radius * Vector({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n)}),
                1, 1, 0);
  for (unsigned int i = 0; i < n; ++i)
    add_contact(snapshot, first + i, first + (i + 1) % n, 1, 0.1);
}
} // namespace

int main()
{
  std::cout.precision(12);
  Snapshot<2> hexagon;
  add_ring(hexagon, {0, 0}, 6);
  add_ellipse(hexagon, {0, 0}, 1, 1, 0);
  for (unsigned int i = 0; i < 6; ++i)
    add_contact(hexagon, 6, i, 1, 0.1);
  std::cout << "seven disks\n";
  print(hexagon, {"coordination", "pores", "contact_directions"});

  std::cout << "and a chain of two that hangs on them\n";
  add_ellipse(hexagon, {4, 0}, 1, 1, 0);
  add_ellipse(hexagon, {6, 0}, 1, 1, 0);
  add_contact(hexagon, 7, 0, 1, 0.1);
  add_contact(hexagon, 8, 7, 1, 0.1);
  print(hexagon, {"coordination", "pores"});

  std::cout << "and a ring of five and one of four apart from it, and a pair\n";
  add_ring(hexagon, {20, 0}, 5);
  add_ring(hexagon, {30, 0}, 4);
  add_ellipse(hexagon, {40, 0}, 1, 1, 0);
  add_ellipse(hexagon, {42, 0}, 1, 1, 0);
  add_contact(hexagon, 18, 19, 1, 0.1);
  print(hexagon, {"coordination", "pores"});

  // All contacts along 30 degrees, twice the force in half of them: a_c is 2, and nothing is left for a_f.
  std::cout << "rows at 30 degrees\n";
  Snapshot<2> rows;
  for (unsigned int i = 0; i < 9; ++i)
    add_ellipse(rows, Point(std::sqrt(3.) * i, i), 1, 1, 0);
  for (unsigned int i = 0; i < 8; ++i)
    add_contact(rows, i, i + 1, 1 + i % 2, 0.1);
  print(rows, {"fabric"});

  // Three in four contacts along 20 degrees, one across.
  std::cout << "three to one\n";
  Snapshot<2> cross;
  const Vector e({std::cos(M_PI / 9), std::sin(M_PI / 9)}), f({-e[1], e[0]});
  add_ellipse(cross, {0, 0}, 1, 1, 0);
  for (const Vector &x : {2. * e, 4. * e, 6. * e, 2. * f})
    add_ellipse(cross, Point(x), 1, 1, 0);
  add_contact(cross, 0, 1, 1, 0.1);
  add_contact(cross, 1, 2, 1, 0.1);
  add_contact(cross, 2, 3, 1, 0.1);
  add_contact(cross, 0, 4, 3, 0.1);
  print(cross, {"fabric"});
}
