// SPDX-License-Identifier: LGPL-2.1-or-later
// A cell that repeats: images, the copy of the cell a place lies in and the nearest image, also where the
// cells above stand to the side by many widths; its motion takes corners where its sides go.
#include <softgrain/driving/cell_motion.h>

#include <iostream>

using namespace softgrain;

namespace
{
/// Images of a place in a cell of which all directions repeat.
template <int dim>
PeriodicCell<dim> images(const std::vector<typename PeriodicCell<dim>::Image> &all,
                         const typename PeriodicCell<dim>::Image &far)
{
  PeriodicCell<dim> cell;
  dealii::Tensor<1, dim> within, little;
  for (unsigned int d = 0; d < dim; ++d)
  {
    cell.periodic[d] = true;
    cell.lower[d] = 1. + d;
    cell.length[d] = 10. / (1. + d);
    within[d] = d == 0 ? 3. : 1.;
    little[d] = d == 0 ? 0.5 : -0.25;
  }
  for (const double offset : {0., 3., 47.})
  {
    cell.offset = offset;
    std::cout << dim << "D, offset " << offset << ":";
    for (const auto &n : all)
      std::cout << ' ' << (cell.image_of(cell.lower + within + cell.shift(n)) == n ? "right" : "wrong");
    std::cout << ", reduced offset " << cell.shift(cell.from_reduced(cell.above()))[0] << ", shortest "
              << cell.shortest(cell.shift(far) + little) << '\n';
  }
  return cell;
}
} // namespace

int main()
{
  const PeriodicCell<2> cell = images<2>({{{0, 0}}, {{3, 0}}, {{-2, 4}}, {{1, -7}}}, {{5, -3}});
  images<3>({{{0, 0, 0}}, {{3, 0, 1}}, {{-2, 4, -5}}, {{1, -7, 2}}}, {{5, -3, 2}});

  CellMotion<2> motion;
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

  CellMotion<3> deep;
  deep.cell.periodic = {{true, true, true}};
  deep.cell.length = {{8., 6., 4.}};
  deep.cell.offset = 3.;
  const dealii::Tensor<1, 3> x({1., 0., 0.}), z({0., 0., 1.});
  deep.add_side(x, 0.5 * x);      // left, inwards
  deep.add_side(-z, -z + 2. * x); // top, inwards and sliding
  dealii::Tensor<2, 3> virial;
  for (unsigned int d = 0; d < 3; ++d)
    virial[d][d] = 1. + d;
  virial[0][2] = 0.5;
  std::cout << "in space " << deep.cell.neighbours().size() << " neighbours; far corner goes "
            << deep.velocity({8., 6., 4.}) << ", offset to " << deep.offset_after(0.1) << "; forces on left "
            << force_on_side(deep.cell, x, virial) << ", top " << force_on_side(deep.cell, -z, virial)
            << '\n';
}
