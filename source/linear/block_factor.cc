// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/linear/block_factor.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace softgrain
{
namespace
{
/// Columns of a panel that are eliminated before the rest of it is changed.
constexpr int strip = 32;
/// Zeros that columns may have in a panel that they share, over its entries; and its width up to which their
/// number does not matter.
constexpr double most_zeros = 0.2;
constexpr int narrow = 24;
/// Rows of a product that are made at once, and multiplications from which on threads share one.
constexpr int piece = 128;
constexpr double worth_sharing = 1e6;

/// Calls @p work(begin, end) for pieces of rows, whose number does not depend on threads.
template <class Work>
void for_pieces(const int n_rows, const double n_multiplications, const Work &work)
{
  if (n_multiplications < worth_sharing)
    return work(0, n_rows);
  parallel_for((n_rows + piece - 1) / piece, 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   work(static_cast<int>(i) * piece, std::min(n_rows, static_cast<int>(i + 1) * piece));
               });
}
} // namespace

void BlockFactor::find_below(const std::vector<int> &sizes,
                             const std::vector<std::pair<int, int>> &neighbours)
{
  below_of.resize(sizes.size());
  for (std::vector<int> &list : below_of)
    list.clear();
  for (const auto &[i, j] : neighbours)
    if (i != j && sizes[i] > 0 && sizes[j] > 0)
      below_of[std::min(i, j)].push_back(std::max(i, j));
  for (std::vector<int> &list : below_of)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

void BlockFactor::find_panels(const std::vector<int> &sizes,
                              const std::vector<std::pair<int, int>> &neighbours)
{
  const int n = sizes.size();
  find_below(sizes, neighbours);
  n_panels = 0;
  panel_of.assign(n, -1);
  double zeros = 0.; // in the last panel
  int height_below = 0;
  for (int j = 0; j < n; ++j)
  {
    if (sizes[j] == 0)
      continue;
    const std::vector<int> &here = below_of[j];
    // The first block below inherits all others.
    if (here.size() > 1)
    {
      std::vector<int> &heir = below_of[here.front()];
      merged.clear();
      std::set_union(heir.begin(), heir.end(), here.begin() + 1, here.end(), std::back_inserter(merged));
      heir.swap(merged);
    }
    int height = 0;
    for (const int i : here)
      height += sizes[i];
    const Panel *last = n_panels > 0 ? &panels[n_panels - 1] : nullptr;
    const bool follows = last != nullptr && last->rows.size() > last->n_own && last->rows[last->n_own] == j;
    const int width = follows ? last->width() : 0;
    const double more_zeros = zeros + double(width) * (sizes[j] + height - height_below);
    if (follows && (width + sizes[j] <= narrow ||
                    more_zeros < most_zeros * (width + sizes[j]) * (width + sizes[j] + height)))
    {
      zeros = more_zeros;
      panels[n_panels - 1].rows.resize(last->n_own);
    }
    else
    {
      zeros = 0.;
      if (panels.size() == n_panels)
        panels.emplace_back();
      panels[n_panels].rows.clear();
      panels[n_panels].first = begin[j];
      ++n_panels;
    }
    Panel &panel = panels[n_panels - 1];
    panel_of[j] = n_panels - 1;
    panel.rows.push_back(j);
    panel.n_own = panel.rows.size();
    panel.rows.insert(panel.rows.end(), here.begin(), here.end());
    height_below = height;
    panel.offset.assign(1, 0);
    for (const int i : panel.rows)
      panel.offset.push_back(panel.offset.back() + sizes[i]);
  }
}

void BlockFactor::reinit(const std::vector<int> &sizes,
                         const std::vector<std::pair<int, int>> &neighbours,
                         const bool is_symmetric)
{
  symmetric = is_symmetric;
  begin.assign(1, 0);
  for (const int size : sizes)
    begin.push_back(begin.back() + size);
  find_panels(sizes, neighbours);
  std::size_t n_entries = 0;
  for (unsigned int p = 0; p < n_panels; ++p)
  {
    panels[p].place = n_entries;
    n_entries += (symmetric ? 1 : 2) * panels[p].size();
  }
  storage.assign(n_entries, 0.);
}

Eigen::Block<BlockFactor::Entries>
BlockFactor::part(Entries of_panel, const Panel &panel, const int i, const int j) const
{
  const unsigned int row = std::lower_bound(panel.rows.begin(), panel.rows.end(), i) - panel.rows.begin();
  return {of_panel, panel.offset[row], begin[j] - panel.first, begin[i + 1] - begin[i],
          begin[j + 1] - begin[j]};
}

Eigen::Block<BlockFactor::Entries> BlockFactor::block(const int i, const int j)
{
  if (panel_of[j] < 0)
  {
    Entries nothing(storage.data(), 0, 0);
    return {nothing, 0, 0, 0, 0};
  }
  const Panel &panel = panels[panel_of[j]];
  return part(entries_of(panel), panel, i, j);
}

Eigen::Block<BlockFactor::Entries> BlockFactor::transposed_block(const int i, const int j)
{
  const Panel &panel = panels[panel_of[j]];
  return part(right_of(panel), panel, i, j);
}

/// The square of a strip one by one, then what is below it and to the right of it.
bool BlockFactor::factorize_strip(Panel &panel, const int first, const int width)
{
  Entries A = entries_of(panel), right = right_of(panel);
  const int end = first + width, left = panel.width() - end, below = panel.height() - end;
  auto d = D.segment(panel.first + first, width);
  auto square = A.block(first, first, width, width);
  for (int j = 0; j < width; ++j)
  {
    const double pivot = square(j, j);
    if (!(std::abs(pivot) > 0.) || !std::isfinite(pivot))
      return false;
    d[j] = pivot;
    const int after = width - j - 1;
    square.col(j).tail(after) /= pivot;
    for (int k = j + 1; k < width; ++k)
    {
      const int rows = symmetric ? width - k : after;
      square.col(k).tail(rows) -=
          (symmetric ? pivot * square(k, j) : square(j, k)) * square.col(j).tail(rows);
    }
  }
  const auto L = square.triangularView<Eigen::UnitLower>();
  const double n_multiplications = 0.5 * below * width * width;
  if (symmetric)
    for_pieces(below, n_multiplications,
               [&](const int from, const int to)
               {
                 auto rows = A.block(end + from, first, to - from, width);
                 L.transpose().solveInPlace<Eigen::OnTheRight>(rows);
                 for (int j = 0; j < width; ++j)
                   rows.col(j) /= d[j];
               });
  else
  {
    auto above = A.block(first, end, width, left);
    L.solveInPlace(above);
    for_pieces(below, n_multiplications,
               [&](const int from, const int to)
               {
                 auto rows = A.block(end + from, first, to - from, width);
                 square.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(rows);
               });
    const int beyond = panel.height() - panel.width();
    for_pieces(beyond, n_multiplications,
               [&](const int from, const int to)
               {
                 auto rows = right.block(panel.width() + from, first, to - from, width);
                 L.transpose().solveInPlace<Eigen::OnTheRight>(rows);
               });
  }
  return true;
}

/// What a strip changes to the right of it in its panel.
void BlockFactor::subtract_strip(Panel &panel, const int first, const int width)
{
  Entries A = entries_of(panel), right = right_of(panel);
  const int end = first + width, left = panel.width() - end, below = panel.height() - end;
  if (left == 0)
    return;
  Eigen::MatrixXd above; // rows of the strip beyond it
  if (symmetric)
    above = D.segment(panel.first + first, width).asDiagonal() * A.block(end, first, left, width).transpose();
  else
    above = A.block(first, end, width, left);
  const double n_multiplications = double(below) * width * left;
  for_pieces(below, n_multiplications,
             [&](const int from, const int to)
             {
               // A piece of a symmetric square ends at its diagonal.
               const int columns = symmetric ? std::min(left, to) : left;
               A.block(end + from, end, to - from, columns).noalias() -=
                   A.block(end + from, first, to - from, width) * above.leftCols(columns);
             });
  if (symmetric)
    return;
  const int beyond = panel.height() - panel.width();
  const Eigen::MatrixXd low = A.block(end, first, left, width).transpose();
  for_pieces(beyond, n_multiplications,
             [&](const int from, const int to)
             {
               right.block(panel.width() + from, end, to - from, left).noalias() -=
                   right.block(panel.width() + from, first, to - from, width) * low;
             });
}

bool BlockFactor::factorize_panel(Panel &panel)
{
  const int n = panel.width();
  if (!symmetric)
    entries_of(panel).topRows(n) += right_of(panel).topRows(n).transpose();
  for (int first = 0; first < n; first += strip)
  {
    const int width = std::min(n - first, strip);
    if (!factorize_strip(panel, first, width))
      return false;
    subtract_strip(panel, first, width);
  }
  return true;
}

/// What a panel changes in another one, whose columns are its row blocks from @p first to @p end.
void BlockFactor::subtract_from(const Panel &target,
                                const Panel &panel,
                                const unsigned int first,
                                const unsigned int end)
{
  const Entries entries = entries_of(panel), right = right_of(panel);
  Entries of_target = entries_of(target), right_of_target = right_of(target);
  const int width = panel.width(), from = panel.offset[first], to = panel.offset[end],
            n_rows = panel.height() - from, n_beyond = panel.height() - to;
  static thread_local Eigen::MatrixXd above, change, change_of_right;
  if (symmetric)
    above = D.segment(panel.first, width).asDiagonal() * entries.middleRows(from, to - from).transpose();
  else
  {
    above = right.middleRows(from, to - from).transpose();
    change_of_right.resize(n_beyond, to - from);
    change_of_right.noalias() = right.bottomRows(n_beyond) * entries.middleRows(from, to - from).transpose();
  }
  change.resize(n_rows, to - from);
  change.noalias() = entries.bottomRows(n_rows) * above;
  unsigned int there = 0;
  for (unsigned int s = first; s < panel.rows.size(); ++s)
  {
    while (target.rows[there] != panel.rows[s])
      ++there;
    const int size = panel.offset[s + 1] - panel.offset[s], row = target.offset[there];
    for (unsigned int r = first; r < end; ++r)
    {
      const int column = begin[panel.rows[r]] - target.first, n = panel.offset[r + 1] - panel.offset[r];
      of_target.block(row, column, size, n) -=
          change.block(panel.offset[s] - from, panel.offset[r] - from, size, n);
      if (!symmetric && s >= end)
        right_of_target.block(row, column, size, n) -=
            change_of_right.block(panel.offset[s] - to, panel.offset[r] - from, size, n);
    }
  }
}

/// What a panel changes to the right of it and below.
void BlockFactor::subtract(const Panel &panel)
{
  std::vector<unsigned int> first; // row block of every panel that is changed
  for (unsigned int r = panel.n_own; r < panel.rows.size(); ++r)
    if (r == panel.n_own || panel_of[panel.rows[r]] != panel_of[panel.rows[r - 1]])
      first.push_back(r);
  if (first.empty())
    return;
  first.push_back(panel.rows.size());
  const auto work = [&](const std::size_t from, const std::size_t to)
  {
    for (std::size_t i = from; i < to; ++i)
      subtract_from(panels[panel_of[panel.rows[first[i]]]], panel, first[i], first[i + 1]);
  };
  const double below = panel.height() - panel.width();
  if (0.5 * below * below * panel.width() < worth_sharing)
    work(0, first.size() - 1);
  else
    parallel_for(first.size() - 1, 1, work);
}

bool BlockFactor::factorize()
{
  D.resize(begin.back());
  for (unsigned int p = 0; p < n_panels; ++p)
  {
    if (!factorize_panel(panels[p]))
      return false;
    subtract(panels[p]);
  }
  return true;
}

unsigned int BlockFactor::n_negative() const
{
  return (D.array() < 0.).count();
}

void BlockFactor::solve(Eigen::VectorXd &x) const
{
  static thread_local Eigen::VectorXd below;
  for (unsigned int p = 0; p < n_panels; ++p)
  {
    const Panel &panel = panels[p];
    const ConstEntries entries = entries_of(panel);
    const int n = panel.width();
    auto here = x.segment(panel.first, n);
    entries.topRows(n).triangularView<Eigen::UnitLower>().solveInPlace(here);
    below.noalias() = entries.bottomRows(panel.height() - n) * here;
    for (unsigned int r = panel.n_own; r < panel.rows.size(); ++r)
      x.segment(begin[panel.rows[r]], panel.offset[r + 1] - panel.offset[r]) -=
          below.segment(panel.offset[r] - n, panel.offset[r + 1] - panel.offset[r]);
  }
  if (symmetric)
    x.array() /= D.array();
  for (unsigned int p = n_panels; p-- > 0;)
  {
    const Panel &panel = panels[p];
    const ConstEntries entries = entries_of(panel);
    const int n = panel.width(), height_below = panel.height() - n;
    below.resize(height_below);
    for (unsigned int r = panel.n_own; r < panel.rows.size(); ++r)
    {
      const int size = panel.offset[r + 1] - panel.offset[r];
      below.segment(panel.offset[r] - n, size) = x.segment(begin[panel.rows[r]], size);
    }
    auto here = x.segment(panel.first, n);
    here.noalias() -= (symmetric ? entries : right_of(panel)).bottomRows(height_below).transpose() * below;
    if (symmetric)
      entries.topRows(n).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(here);
    else
      entries.topRows(n).triangularView<Eigen::Upper>().solveInPlace(here);
  }
}
} // namespace softgrain
