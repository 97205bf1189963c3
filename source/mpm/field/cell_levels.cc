// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/field/cell_levels.h>
#include <softgrain/mpm/field/lattice_box.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Largest multiple of @p size that is not above @p i.
int multiple_below(const int i, const int size)
{
  return (i >= 0 ? i / size : -((size - 1 - i) / size)) * size;
}
} // namespace

template <int dim>
CellLevels<dim>::CellLevels(const Lattice<dim> &lattice,
                            const dealii::Point<dim> &lower,
                            const dealii::Point<dim> &upper,
                            const unsigned int highest,
                            const Cut &cut)
    : highest_level(highest)
{
  const int largest = 1 << highest;
  const Index lowest_cell = lattice.cell_of(lower), highest_cell = lattice.cell_of(upper);
  std::size_t total = 1;
  for (unsigned int d = 0; d < dim; ++d)
  {
    // One largest cell more on each side: an outline that ends on a line of the grid may be in cells beyond
    // it by rounding, or after it has been moved.
    origin[d] = multiple_below(lowest_cell[d], largest) - largest;
    last[d] = multiple_below(highest_cell[d], largest) + 2 * largest - 1;
    total *= last[d] - origin[d] + 1;
  }
  levels.assign(total, highest);
  for (unsigned int l = highest; l > 0; --l)
    for_box<dim>(origin, last,
                 [&](const Index &c)
                 {
                   if (level(c) != l || first(c) != c)
                     return;
                   dealii::Point<dim> begin = lattice.lower(), end;
                   for (unsigned int d = 0; d < dim; ++d)
                   {
                     begin[d] += c[d] * lattice.cell_size();
                     end[d] = begin[d] + (1 << l) * lattice.cell_size();
                   }
                   if (cut(begin, end, l))
                     cut_cell(c);
                 });
  balance();
}

template <int dim>
std::size_t CellLevels<dim>::offset(const Index &c) const
{
  std::size_t result = 0;
  for (int d = dim - 1; d >= 0; --d)
    result = result * (last[d] - origin[d] + 1) + (c[d] - origin[d]);
  return result;
}

template <int dim>
void CellLevels<dim>::cut_cell(const Index &begin)
{
  const unsigned int next = level(begin) - 1;
  Index end = begin;
  for (unsigned int d = 0; d < dim; ++d)
    end[d] += edge(begin) - 1;
  for_box<dim>(begin, end, [&](const Index &c) { levels[offset(c)] = next; });
}

template <int dim>
void CellLevels<dim>::balance()
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for_box<dim>(origin, last,
                 [&](const Index &c)
                 {
                   Index low, high;
                   for (unsigned int d = 0; d < dim; ++d)
                   {
                     low[d] = std::max(origin[d], c[d] - 1);
                     high[d] = std::min(last[d], c[d] + 1);
                   }
                   for_box<dim>(low, high,
                                [&](const Index &neighbour)
                                {
                                  if (level(neighbour) <= level(c) + 1)
                                    return;
                                  cut_cell(first(neighbour));
                                  changed = true;
                                });
                 });
  }
}

template <int dim>
unsigned int CellLevels<dim>::level(const Index &c) const
{
  for (unsigned int d = 0; d < dim; ++d)
    if (c[d] < origin[d] || c[d] > last[d])
      return highest_level;
  return levels[offset(c)];
}

template <int dim>
typename CellLevels<dim>::Index CellLevels<dim>::first(const Index &c) const
{
  Index result;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = multiple_below(c[d], edge(c));
  return result;
}

template class CellLevels<2>;
template class CellLevels<3>;
} // namespace softgrain::mpm
