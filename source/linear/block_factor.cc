// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/block_factor.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace softgrain
{
namespace
{
/// Columns of a diagonal block that are eliminated one by one before the rest of it is changed.
constexpr int strip = 32;
} // namespace

void BlockFactor::reinit(const std::vector<int> &sizes,
                         const std::vector<std::pair<int, int>> &neighbours,
                         const bool is_symmetric)
{
  symmetric = is_symmetric;
  const int n = sizes.size();
  begin.assign(1, 0);
  for (const int size : sizes)
    begin.push_back(begin.back() + size);
  std::vector<std::set<int>> below(n);
  for (const auto &[i, j] : neighbours)
    if (i != j && sizes[i] > 0 && sizes[j] > 0)
      below[std::min(i, j)].insert(std::max(i, j));
  panels.assign(n, Panel());
  for (int j = 0; j < n; ++j)
  {
    // The first block below inherits all others.
    if (!below[j].empty())
      below[*below[j].begin()].insert(std::next(below[j].begin()), below[j].end());
    Panel &panel = panels[j];
    panel.rows.assign(1, j);
    panel.rows.insert(panel.rows.end(), below[j].begin(), below[j].end());
    panel.offset.assign(1, 0);
    for (const int i : panel.rows)
      panel.offset.push_back(panel.offset.back() + sizes[i]);
    panel.entries.setZero(panel.offset.back(), sizes[j]);
    if (!symmetric)
      panel.right.setZero(panel.offset.back() - sizes[j], sizes[j]);
  }
}

unsigned int BlockFactor::place(const Panel &panel, const int i) const
{
  return std::lower_bound(panel.rows.begin(), panel.rows.end(), i) - panel.rows.begin();
}

Eigen::Block<Eigen::MatrixXd> BlockFactor::block(const int i, const int j)
{
  Panel &panel = panels[j];
  const unsigned int row = place(panel, i);
  return panel.entries.block(panel.offset[row], 0, panel.offset[row + 1] - panel.offset[row],
                             panel.entries.cols());
}

Eigen::Block<Eigen::MatrixXd> BlockFactor::transposed_block(const int i, const int j)
{
  Panel &panel = panels[j];
  const unsigned int row = place(panel, i);
  return panel.right.block(panel.offset[row] - panel.offset[1], 0, panel.offset[row + 1] - panel.offset[row],
                           panel.right.cols());
}

/// Strip by strip: the columns of a strip, then what they change to the right of them.
bool BlockFactor::factorize_panel(Panel &panel, const int begin_of_d)
{
  Eigen::MatrixXd &A = panel.entries;
  const int n = A.cols(), n_rows = A.rows();
  for (int first = 0; first < n; first += strip)
  {
    const int width = std::min(n - first, strip), end = first + width, left = n - end;
    for (int j = first; j < end; ++j)
    {
      const double pivot = A(j, j);
      if (!(std::abs(pivot) > 0.) || !std::isfinite(pivot))
        return false;
      D[begin_of_d + j] = pivot;
      A.col(j).tail(n_rows - j - 1) /= pivot;
      for (int k = j + 1; k < end; ++k)
        A.col(k).tail(n_rows - (symmetric ? k : j + 1)) -=
            (symmetric ? pivot * A(k, j) : A(j, k)) * A.col(j).tail(n_rows - (symmetric ? k : j + 1));
    }
    Eigen::MatrixXd above(width, left); // rows of the strip beyond it
    if (symmetric)
      above =
          D.segment(begin_of_d + first, width).asDiagonal() * A.block(end, first, left, width).transpose();
    else
    {
      const auto L = A.block(first, first, width, width).triangularView<Eigen::UnitLower>();
      above = A.block(first, end, width, left);
      L.solveInPlace(above);
      A.block(first, end, width, left) = above;
      Eigen::MatrixXd beyond = panel.right.middleCols(first, width).transpose();
      L.solveInPlace(beyond);
      panel.right.middleCols(first, width) = beyond.transpose();
      panel.right.rightCols(left).noalias() -=
          panel.right.middleCols(first, width) * A.block(end, first, left, width).transpose();
    }
    A.block(end, end, n_rows - end, left).noalias() -= A.block(end, first, n_rows - end, width) * above;
  }
  return true;
}

/// What a column and a row of blocks change to the right of them and below.
void BlockFactor::subtract(const Panel &panel, const int begin_of_d)
{
  const int width = panel.entries.cols(), beyond = panel.offset[1];
  Eigen::MatrixXd change, change_of_right;
  for (unsigned int r = 1; r < panel.rows.size(); ++r)
  {
    const int from = panel.offset[r], to = panel.offset[r + 1], n = to - from,
              n_rows = panel.entries.rows() - from;
    if (symmetric)
      change.noalias() = panel.entries.bottomRows(n_rows) * (D.segment(begin_of_d, width).asDiagonal() *
                                                             panel.entries.middleRows(from, n).transpose());
    else
    {
      change.noalias() =
          panel.entries.bottomRows(n_rows) * panel.right.middleRows(from - beyond, n).transpose();
      change_of_right.noalias() =
          panel.right.bottomRows(n_rows - n) * panel.entries.middleRows(from, n).transpose();
    }
    Panel &target = panels[panel.rows[r]];
    unsigned int there = 0;
    for (unsigned int s = r; s < panel.rows.size(); ++s)
    {
      while (target.rows[there] != panel.rows[s])
        ++there;
      const int size = panel.offset[s + 1] - panel.offset[s];
      target.entries.middleRows(target.offset[there], size) -=
          change.middleRows(panel.offset[s] - from, size);
      if (!symmetric && s > r)
        target.right.middleRows(target.offset[there] - target.offset[1], size) -=
            change_of_right.middleRows(panel.offset[s] - to, size);
    }
  }
}

bool BlockFactor::factorize()
{
  D.resize(begin.back());
  for (unsigned int j = 0; j < panels.size(); ++j)
  {
    if (panels[j].entries.cols() == 0)
      continue;
    if (!factorize_panel(panels[j], begin[j]))
      return false;
    subtract(panels[j], begin[j]);
  }
  return true;
}

unsigned int BlockFactor::n_negative() const
{
  return (D.array() < 0.).count();
}

void BlockFactor::solve(Eigen::VectorXd &x) const
{
  for (unsigned int j = 0; j < panels.size(); ++j)
  {
    const Panel &panel = panels[j];
    const int n = panel.entries.cols();
    auto here = x.segment(begin[j], n);
    panel.entries.topRows(n).triangularView<Eigen::UnitLower>().solveInPlace(here);
    for (unsigned int r = 1; r < panel.rows.size(); ++r)
      x.segment(begin[panel.rows[r]], panel.offset[r + 1] - panel.offset[r]).noalias() -=
          panel.entries.middleRows(panel.offset[r], panel.offset[r + 1] - panel.offset[r]) * here;
  }
  if (symmetric)
    x.array() /= D.array();
  for (int j = panels.size() - 1; j >= 0; --j)
  {
    const Panel &panel = panels[j];
    const int n = panel.entries.cols();
    const auto beyond = symmetric ? panel.entries.bottomRows(panel.entries.rows() - n)
                                  : panel.right.bottomRows(panel.right.rows());
    auto here = x.segment(begin[j], n);
    for (unsigned int r = 1; r < panel.rows.size(); ++r)
    {
      const int size = panel.offset[r + 1] - panel.offset[r];
      here.noalias() -= beyond.middleRows(panel.offset[r] - panel.offset[1], size).transpose() *
                        x.segment(begin[panel.rows[r]], size);
    }
    if (symmetric)
      panel.entries.topRows(n).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(here);
    else
      panel.entries.topRows(n).triangularView<Eigen::Upper>().solveInPlace(here);
  }
}
} // namespace softgrain
