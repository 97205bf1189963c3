// SPDX-License-Identifier: LGPL-2.1-or-later
// Factors of what rays and frames do to each other, block by block.
#include <softgrain/mpm/contact/frame_system.h>

#include <algorithm>

namespace softgrain::mpm
{
/// Which columns are unknowns, and the factors of what they do to each other: without friction that slips,
/// and with it.
template <int dim>
bool FrameSystem<dim>::factorize_active()
{
  number.assign(columns.size(), -1);
  std::vector<int> sizes(n_blocks, 0);
  int n = 0;
  for (const unsigned int i : order)
    if (counts(i))
    {
      number[i] = n++;
      ++sizes[block_of[i]];
    }
  any_slips = false;
  for (unsigned int i = 0; i < columns.size(); ++i)
    any_slips = any_slips || slips_with_force(i);
  factor.reinit(sizes, neighbours);
  if (any_slips)
    slip_factor.reinit(sizes, neighbours, false);
  const auto add = [&](const unsigned int i, const unsigned int j, const double value)
  {
    if (number[i] < 0 || number[j] < 0)
      return;
    add_entry(factor, std::max(number[i], number[j]) == number[i] ? i : j,
              std::max(number[i], number[j]) == number[i] ? j : i, value);
    if (!any_slips)
      return;
    add_entry(slip_factor, i, j, value);
    if (i != j)
      add_entry(slip_factor, j, i, value);
  };
  for (const auto &entry : own)
  {
    add(entry.row(), entry.col(), entry.value());
    // What slips gives to walls under loads.
    if (const unsigned int i = entry.row(); slips_with_force(i) && number[entry.col()] >= 0)
      add_entry(slip_factor, entry.col(), columns[i].mate, slips(i) * columns[i].bound * entry.value());
  }
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (give_of(i) != 0.)
      add(i, i, give_of(i));
  for (unsigned int b = 0; b < of_body.size(); ++b)
    add_body(b);
  if (!factor.factorize())
    return false;
  negative = factor.n_negative();
  return !any_slips || slip_factor.factorize();
}

template <int dim>
void FrameSystem<dim>::add_entry(BlockFactor &to,
                                 const unsigned int i,
                                 const unsigned int j,
                                 const double value) const
{
  const int row = number[i] - to.first()[block_of[i]], column = number[j] - to.first()[block_of[j]];
  if (block_of[i] >= block_of[j])
    to.block(block_of[i], block_of[j])(row, column) += value;
  else
    to.transposed_block(block_of[j], block_of[i])(column, row) += value;
}

/// W of a body, block by block.
template <int dim>
void FrameSystem<dim>::add_body(const unsigned int b)
{
  struct Entry
  {
    int in_W, in_block;
    int slide;     ///< in W, of a ray that slips; else -1
    double factor; ///< friction over force, with its sign
  };
  struct Part
  {
    int block;
    std::vector<Entry> entries;
  };
  const std::vector<unsigned int> &list = of_body[b];
  std::vector<Part> parts;
  for (unsigned int i = 0; i < list.size(); ++i)
    if (const Column &column = columns[list[i]]; number[list[i]] >= 0)
    {
      const int block = block_of[list[i]];
      if (parts.empty() || parts.back().block != block)
        parts.push_back({block, {}});
      Entry entry{static_cast<int>(i), number[list[i]] - factor.first()[block], -1, 0.};
      if (const unsigned int slide = column.mate;
          column.kind == Column::ray && slide != Column::none && slips_with_force(slide))
      {
        entry.slide = std::lower_bound(list.begin() + i, list.end(), slide,
                                       [&](const unsigned int x, const unsigned int y)
                                       { return columns[x].kind != Column::wall && x < y; }) -
                      list.begin();
        entry.factor = slips(slide) * columns[slide].bound;
      }
      parts.back().entries.push_back(entry);
    }
  const Eigen::MatrixXd &here = W[b];
  const auto with_slip = [&](const Entry &row, const Entry &column)
  {
    const double without = here(row.in_W, column.in_W);
    return column.slide < 0 ? without : without + column.factor * here(row.in_W, column.slide);
  };
  for (const Part &one : parts)
    for (const Part &other : parts)
    {
      if (one.block < other.block)
        continue;
      auto block = factor.block(one.block, other.block);
      for (const Entry &column : other.entries)
        for (const Entry &row : one.entries)
          block(row.in_block, column.in_block) += here(row.in_W, column.in_W);
      if (!any_slips)
        continue;
      auto low = slip_factor.block(one.block, other.block);
      for (const Entry &column : other.entries)
        for (const Entry &row : one.entries)
          low(row.in_block, column.in_block) += with_slip(row, column);
      if (one.block == other.block)
        continue;
      auto high = slip_factor.transposed_block(one.block, other.block);
      for (const Entry &row : other.entries)
        for (const Entry &column : one.entries)
          high(column.in_block, row.in_block) += with_slip(row, column);
    }
}

template bool FrameSystem<2>::factorize_active();
template bool FrameSystem<3>::factorize_active();
} // namespace softgrain::mpm
