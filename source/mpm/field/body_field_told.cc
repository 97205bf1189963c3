// SPDX-License-Identifier: LGPL-2.1-or-later
// The field of a body as it is known where its points do not lie.
#include <softgrain/mpm/field/body_field.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);
} // namespace

template <int dim>
void BodyField<dim>::tell(std::vector<double> &numbers) const
{
  numbers.push_back(cell_index.size());
  for (const Index &c : cell_index)
    numbers.insert(numbers.end(), c.begin(), c.end());
  // Not found from the cells again: what is computed elsewhere may be rounded in another way.
  for (const dealii::Point<dim> &x : own_nodes.place)
    numbers.insert(numbers.end(), x.begin_raw(), x.end_raw());
  numbers.push_back(spreading.dependent.n_constraints());
  for (const auto &line : spreading.dependent.get_lines())
  {
    numbers.push_back(line.index);
    numbers.push_back(line.entries.size());
    for (const auto &[node, weight] : line.entries)
      numbers.insert(numbers.end(), {static_cast<double>(node), weight});
  }
}

template <int dim>
const double *BodyField<dim>::take(const Lattice<dim> &the_lattice,
                                   const ShapeFunction &the_shape,
                                   const CellLevels<dim> *the_levels,
                                   const double *numbers)
{
  *this = BodyField();
  stand_on(the_lattice, the_shape, the_levels);
  const auto count = [&]() { return static_cast<std::size_t>(*numbers++); };
  cell_index.resize(count());
  for (Index &c : cell_index)
    for (int &i : c)
      i = static_cast<int>(*numbers++);
  Index lower = cell_index.front(), upper = lower;
  for (const Index &c : cell_index)
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = std::min(lower[d], c[d]);
      upper[d] = std::max(upper[d], c[d]);
    }
  cell_box.resize(lower, upper, none);
  for (unsigned int c = 0; c < cell_index.size(); ++c)
    cell_box(cell_index[c]) = c;
  own_cells.point_start.assign(cell_index.size() + 1, 0);
  number_nodes();
  for (dealii::Point<dim> &x : own_nodes.place)
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = *numbers++;
  for (std::size_t n_lines = count(); n_lines > 0; --n_lines)
  {
    const std::size_t line = count(), n_entries = count();
    Entries entries;
    for (std::size_t e = 0; e < n_entries; ++e, numbers += 2)
      entries.emplace_back(static_cast<unsigned int>(numbers[0]), numbers[1]);
    spreading.dependent.add_line(line);
    spreading.dependent.add_entries(line, entries);
  }
  // They are not closed: they were before they were told, and weights would be rounded once more.
  spreading.number.assign(own_nodes.n(), none);
  for (unsigned int i = 0; i < own_nodes.n(); ++i)
    if (!spreading.dependent.is_constrained(i))
    {
      spreading.number[i] = spreading.independent.size();
      spreading.independent.push_back(i);
    }
  build_cell_dependence();
  return numbers;
}

template void BodyField<2>::tell(std::vector<double> &) const;
template void BodyField<3>::tell(std::vector<double> &) const;
template const double *
BodyField<2>::take(const Lattice<2> &, const ShapeFunction &, const CellLevels<2> *, const double *);
template const double *
BodyField<3>::take(const Lattice<3> &, const ShapeFunction &, const CellLevels<3> *, const double *);
} // namespace softgrain::mpm
