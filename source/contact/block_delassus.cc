// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/block_delassus.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace softgrain::contact
{
void BlockDelassus::reinit(const unsigned int n_contacts, const unsigned int n_components)
{
  if (n_components < 1 || n_components > 3)
    throw InputError("a contact has 1, 2 or 3 components, not " + std::to_string(n_components));
  contacts = n_contacts;
  components = n_components;
  ordered = false;
  blocks.clear();
  row_component.clear();
  values.clear();
  impulse.clear();
}

namespace
{
std::string name_of(const unsigned int b)
{
  return "Delassus block " + std::to_string(b);
}

void check(const Eigen::Ref<const Eigen::MatrixXd> &block, const unsigned int size, const unsigned int b)
{
  if (block.rows() != size || block.cols() != size)
    throw InputError(name_of(b) + " is " + std::to_string(block.rows()) + " x " +
                     std::to_string(block.cols()) + ", but has " + std::to_string(size) + " rows to go to");
  if (size == 0)
    return;
  if (!block.allFinite())
    throw ComputationError(name_of(b) + " is not finite");
  // Rounding of a Cholesky factor is far below this; a wrong sign or order of rows is far above.
  if ((block - block.transpose()).cwiseAbs().maxCoeff() > 1e-6 * block.cwiseAbs().maxCoeff())
    throw InputError(name_of(b) + " is not symmetric");
}
} // namespace

void BlockDelassus::add_block(const std::vector<unsigned int> &block_components,
                              const Eigen::Ref<const Eigen::MatrixXd> &block)
{
  check(block, block_components.size(), blocks.size());
  if (block_components.empty())
    return;
  add_room(block_components);
  place(blocks.size() - 1) = block;
}

void BlockDelassus::set_block(const unsigned int b, const Eigen::Ref<const Eigen::MatrixXd> &block)
{
  check(block, blocks.at(b).size, b);
  place(b) = block;
}

void BlockDelassus::add_room(const std::vector<unsigned int> &block_components)
{
  const unsigned int size = block_components.size();
  std::vector<unsigned int> sorted(block_components);
  std::sort(sorted.begin(), sorted.end());
  if (sorted.back() >= contacts * components)
    throw InputError(name_of(blocks.size()) + " has component " + std::to_string(sorted.back()) +
                     ", but there are only " + std::to_string(contacts * components));
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw InputError(name_of(blocks.size()) + " has a component twice");

  blocks.push_back({size, values.size(), row_component.size()});
  row_component.insert(row_component.end(), block_components.begin(), block_components.end());
  values.resize(values.size() + std::size_t(size) * size);
  ordered = false;
}

Eigen::Map<BlockDelassus::Matrix> BlockDelassus::place(const unsigned int b)
{
  return {values.data() + blocks[b].value, blocks[b].size, blocks[b].size};
}

std::vector<unsigned int> BlockDelassus::block_components(const unsigned int b) const
{
  const auto first = row_component.begin() + blocks.at(b).row;
  return std::vector<unsigned int>(first, first + blocks[b].size);
}

Eigen::MatrixXd BlockDelassus::block(const unsigned int b) const
{
  return Eigen::Map<const Matrix>(values.data() + blocks.at(b).value, blocks[b].size, blocks[b].size);
}

void BlockDelassus::order_rows()
{
  row_start.assign(contacts * components + 1, 0);
  for (const unsigned int component : row_component)
    ++row_start[component + 1];
  for (unsigned int i = 0; i < contacts * components; ++i)
    row_start[i + 1] += row_start[i];
  rows.resize(row_component.size());
  std::vector<unsigned int> next(row_start.begin(), row_start.end() - 1);
  for (const Block &block : blocks)
    for (unsigned int i = 0; i < block.size; ++i)
      rows[next[row_component[block.row + i]]++] = {block.value + std::size_t(i) * block.size, block.row,
                                                    block.size, i};
  ordered = true;
}

void BlockDelassus::begin(const std::vector<double> &impulses)
{
  if (impulses.size() != contacts * components)
    throw InputError("Delassus operator: " + std::to_string(impulses.size()) + " impulses, " +
                     std::to_string(contacts * components) + " expected");
  if (!ordered)
    order_rows();
  impulse.resize(row_component.size());
  for (std::size_t i = 0; i < row_component.size(); ++i)
    impulse[i] = impulses[row_component[i]];
}

void BlockDelassus::diagonal_block(const unsigned int contact, double *block) const
{
  if (!ordered)
    throw std::logic_error("BlockDelassus: begin() must be called after blocks are added");
  std::fill_n(block, components * components, 0.);
  for (unsigned int c = 0; c < components; ++c)
    for (unsigned int d = 0; d < components; ++d)
      for (unsigned int e = row_start[contact * components + c]; e < row_start[contact * components + c + 1];
           ++e)
        for (unsigned int f = row_start[contact * components + d];
             f < row_start[contact * components + d + 1]; ++f)
          if (rows[e].impulse == rows[f].impulse)
            block[c * components + d] += values[rows[e].value + rows[f].local];
}

Eigen::SparseMatrix<double, Eigen::RowMajor> BlockDelassus::assemble() const
{
  const unsigned int n = contacts * components;
  // Of row r: the block and the row in it of every part, start[r], ..., start[r + 1] - 1.
  std::vector<unsigned int> start(n + 1, 0);
  for (const unsigned int component : row_component)
    ++start[component + 1];
  for (unsigned int r = 0; r < n; ++r)
    start[r + 1] += start[r];
  std::vector<std::pair<unsigned int, unsigned int>> parts(row_component.size());
  std::vector<unsigned int> next(start.begin(), start.end() - 1);
  for (unsigned int b = 0; b < blocks.size(); ++b)
    for (unsigned int i = 0; i < blocks[b].size; ++i)
      parts[next[row_component[blocks[b].row + i]]++] = {b, i};
  Eigen::SparseMatrix<double, Eigen::RowMajor> W(n, n);
  W.reserve(values.size());
  std::vector<std::pair<unsigned int, double>> row;
  const auto by_column = [](const auto &a, const auto &b) { return a.first < b.first; };
  for (unsigned int r = 0; r < n; ++r)
  {
    row.clear();
    for (unsigned int p = start[r]; p < start[r + 1]; ++p)
    {
      const auto [b, i] = parts[p];
      const Block &block = blocks[b];
      const std::size_t known = row.size();
      for (unsigned int j = 0; j < block.size; ++j)
        row.emplace_back(row_component[block.row + j], values[block.value + std::size_t(i) * block.size + j]);
      // Stable: what falls on one place is added up in the order of the blocks.
      if (!std::is_sorted(row.begin() + known, row.end(), by_column))
        std::sort(row.begin() + known, row.end(), by_column);
      std::inplace_merge(row.begin(), row.begin() + known, row.end(), by_column);
    }
    W.startVec(r);
    for (std::size_t k = 0; k < row.size();)
    {
      double &sum = W.insertBack(r, row[k].first) = row[k].second;
      for (const std::size_t first = k++; k < row.size() && row[k].first == row[first].first; ++k)
        sum += row[k].second;
    }
  }
  W.finalize();
  return W;
}
} // namespace softgrain::contact
