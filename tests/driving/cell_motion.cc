// SPDX-License-Identifier: LGPL-2.1-or-later
// A cell that repeats: images, the copy of the cell a place lies in and the nearest image, also where the
// cells above stand to the side by many widths; its motion takes corners where its sides go.
#include <softgrain/driving/cell_motion.h>

#include <iostream>

using namespace softgrain;

int main()
{
  PeriodicCell cell;
  cell.periodic = {{true, true}};
  cell.lower = {1., 2.};
  cell.length = {{10., 5.}};
  for (const double offset : {0., 3., 47.})
  {
    cell.offset = offset;
    const dealii::Point<2> inside(4., 3.);
    std::cout << "offset " << offset << ":";
    for (const PeriodicCell::Image &n : {PeriodicCell::Image{{0, 0}}, {{3, 0}}, {{-2, 4}}, {{1, -7}}})
    {
      const PeriodicCell::Image found = cell.image_of(inside + cell.shift(n));
      std::cout << ' ' << (found == n ? "right" : "wrong");
    }
    const PeriodicCell::Image above = cell.from_reduced({{0, 1}});
    std::cout << ", reduced offset " << cell.shift(above)[0] << ", shortest "
              << cell.shortest(cell.shift({{5, -3}}) + dealii::Tensor<1, 2>({0.5, -0.25})) << '\n';
  }

  CellMotion motion;
  motion.cell = cell;
  const dealii::Tensor<1, 2> up({0., 1.}), right({1., 0.});
  motion.add_side(right, 0.5 * right);          // left, inwards
  motion.add_side(-right, -0.25 * right);       // right, inwards
  motion.add_side(up, dealii::Tensor<1, 2>());  // bottom, at rest
  motion.add_side(-up, -0.1 * up + 2. * right); // top, inwards and sliding
  std::cout << "lower corner " << motion.velocity({1., 2.}) << ", right of it " << motion.velocity({11., 2.})
            << ", above it " << motion.velocity({1., 7.}) << '\n';
  // The cell above: its corner goes where the place goes that is there.
  std::cout << "offset goes from " << cell.offset << " to " << motion.offset_after(0.1) << ", place there by "
            << 0.1 * (motion.velocity(cell.lower + cell.shift({{0, 1}})) - motion.velocity(cell.lower))
            << '\n';
}
