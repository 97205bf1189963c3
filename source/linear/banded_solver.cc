// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/even_exponent.h>
#include <softgrain/base/parallel.h>
#include <softgrain/linear/banded_solver.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
namespace
{
using Sparse = SystemMatrix::Sparse;
using Kernels = DenseKernels;

constexpr int narrow_band = 192; ///< up to which panels are half as wide
constexpr int largest_block = 32;
constexpr int panels_at_once = 3; ///< of which the squares of condensed rows are summed
constexpr int rows_at_once = 64;  ///< contact rows that one thread condenses
using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, largest_block, largest_block>;

/// Cholesky's factor L in place of the lower triangle. @return whether it has one
bool factorize_positive(Block &L)
{
  const int n = L.rows(), stride = L.outerStride();
  for (int j = 0; j < n; ++j)
  {
    const double pivot = L(j, j);
    if (!(pivot > 0.))
      return false;
    const double scale = 1. / std::sqrt(pivot);
    const int first = j / Kernels::lanes * Kernels::lanes;
    double *const own = L.data() + j * stride;
    for (int i = first; i < n; i += Kernels::lanes)
      Kernels::store(own + i, Kernels::load(own + i) * scale);
    for (int c = j + 1; c < n; ++c)
    {
      double *const other = L.data() + c * stride;
      for (int i = c / Kernels::lanes * Kernels::lanes; i < n; i += Kernels::lanes)
        Kernels::store(other + i, Kernels::load(other + i) - Kernels::load(own + i) * own[c]);
    }
  }
  return true;
}

/// L S Lᵀ in place, without pivoting, as the band asks for. @p negative takes the columns with the sign -,
/// counted from @p first. @return whether no pivot is zero
bool factorize_with_signs(Block &L, const int first, std::vector<int> &negative)
{
  const int n = L.rows();
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, largest_block, 1> sign(n);
  for (int j = 0; j < n; ++j)
  {
    double pivot = L(j, j);
    for (int i = 0; i < j; ++i)
      pivot -= sign[i] * L(j, i) * L(j, i);
    if (!(std::abs(pivot) > 1e-12 * std::abs(L(j, j))))
      return false;
    sign[j] = pivot > 0. ? 1. : -1.;
    if (pivot < 0.)
      negative.push_back(first + j);
    L(j, j) = std::sqrt(std::abs(pivot));
    for (int r = j + 1; r < n; ++r)
    {
      double value = L(r, j);
      for (int i = 0; i < j; ++i)
        value -= sign[i] * L(r, i) * L(j, i);
      L(r, j) = value * sign[j] / L(j, j);
    }
  }
  return true;
}

/// Writes L⁻¹ to the first rows of @p out, with zeros above its diagonal. Of L the diagonal and what is
/// below.
void invert_lower(Block &L, const Kernels::Out &out)
{
  const int n = L.rows();
  Block X = Block::Identity(n, n);
  for (int k = 0; k < n; ++k)
  {
    const double scale = 1. / L(k, k);
    L.col(k).head(k + 1).setZero();
    for (int j = 0; j <= k; ++j)
    {
      const double value = X(k, j) * scale;
      X(k, j) = value;
      double *const column = &X(0, j);
      const double *const factor = &L(0, k);
      for (int i = k / Kernels::lanes * Kernels::lanes; i < n; i += Kernels::lanes)
        Kernels::store(column + i, Kernels::load(column + i) - Kernels::load(factor + i) * value);
    }
  }
  for (int j = 0; j < n; ++j)
    std::copy_n(&X(0, j), n, out.at(0, j));
}

int bandwidth_of(const Sparse &matrix, const std::vector<int> &order)
{
  int width = 0;
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
      width = std::max(width, std::abs(order[entry.row()] - order[j]));
  return width;
}

std::vector<int> reverse_cuthill_mckee(const Sparse &matrix)
{
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                      boost::property<boost::vertex_color_t, boost::default_color_type,
                                                      boost::property<boost::vertex_degree_t, int>>>;
  Graph graph(matrix.rows());
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
      if (entry.row() > j)
        boost::add_edge(entry.row(), j, graph);
  std::vector<boost::graph_traits<Graph>::vertex_descriptor> inverse(matrix.rows());
  boost::cuthill_mckee_ordering(graph, inverse.rbegin(), boost::get(boost::vertex_color, graph),
                                boost::make_degree_map(graph));
  std::vector<int> order(matrix.rows());
  for (int i = 0; i < static_cast<int>(inverse.size()); ++i)
    order[inverse[i]] = i;
  return order;
}

std::pair<std::vector<int>, int> best_order(const Sparse &matrix)
{
  std::vector<int> natural(matrix.rows());
  std::iota(natural.begin(), natural.end(), 0);
  std::vector<int> other = reverse_cuthill_mckee(matrix);
  const int natural_width = bandwidth_of(matrix, natural), other_width = bandwidth_of(matrix, other);
  return natural_width <= other_width ? std::make_pair(std::move(natural), natural_width)
                                      : std::make_pair(std::move(other), other_width);
}
} // namespace

unsigned int BandedSolver::bandwidth(const SystemMatrix &matrix)
{
  return best_order(matrix.lower()).second;
}

void BandedSolver::analyze(const Sparse &matrix)
{
  int width;
  std::tie(order, width) = best_order(matrix);
  block = width <= narrow_band ? 16 : 32;
  n_panels = (matrix.rows() + block - 1) / block;
  // A factor fills a row from its first entry on: a panel reaches as far as those before it.
  panels.assign(n_panels, Panel());
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
    {
      const int row = std::max(order[entry.row()], order[j]), column = std::min(order[entry.row()], order[j]);
      panels[column / block].end = std::max(panels[column / block].end, row + 1);
    }
  std::size_t size = 0;
  for (int k = 0; k < n_panels; ++k)
  {
    Panel &panel = panels[k];
    panel.first = k * block;
    panel.end = std::max({panel.end, panel.first + block, k > 0 ? panels[k - 1].end : 0});
    panel.end = std::min(Kernels::filled(panel.end), n_panels * block);
    panel.start = size;
    size += static_cast<std::size_t>(panel.height()) * block;
  }
  values.assign(size, 0.);
  column_start.resize(n_panels * block);
  for (int i = 0; i < n_panels * block; ++i)
  {
    const Panel &panel = panels[i / block];
    column_start[i] = static_cast<std::ptrdiff_t>(panel.start) +
                      static_cast<std::ptrdiff_t>(i - panel.first) * panel.height() - panel.first;
  }
}

void BandedSolver::fill(const Sparse &matrix)
{
  std::fill(values.begin(), values.end(), 0.);
  factor = matrix.nonZeros() == 0 ? 1. : for_even_exponent(matrix.valuePtr()[0]);
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
    {
      const int a = order[entry.row()], b = order[j];
      values[column_start[std::min(a, b)] + std::max(a, b)] += factor * entry.value();
    }
  // The last panel may reach beyond the matrix: ones on the diagonal leave the rest alone.
  for (int i = matrix.rows(); i < n_panels * block; ++i)
    *of_panel(n_panels - 1).at(i - panels.back().first, i - panels.back().first) = 1.;
}

/// Diagonal block of a panel as L S L^T, S a sign for every column, and L^-1 in its place. All signs are + in
/// almost every case, and then L is Cholesky's factor.
bool BandedSolver::factorize_diagonal(const int k)
{
  const Kernels::Out panel = of_panel(k);
  const Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> place(panel.data, block, block,
                                                                   Eigen::OuterStride<>(panel.stride));
  Block L = place;
  if (!factorize_positive(L))
  {
    L = place;
    if (!factorize_with_signs(L, panels[k].first, negative))
      return false;
  }
  invert_lower(L, panel);
  return true;
}

bool BandedSolver::factorize(SystemMatrix &matrix)
{
  if (matrix.pattern_is_new())
  {
    analyze(matrix.lower());
    matrix.clear_pattern_flag();
  }
  fill(matrix.lower());
  negative.clear();
  std::vector<double> turned; // L21 S, of a panel with a negative pivot
  for (int k = 0; k < n_panels; ++k)
  {
    const std::size_t n_negative_before = negative.size();
    if (!factorize_diagonal(k))
      return false;
    const Panel &own = panels[k];
    const int n_below = own.end - own.first - block;
    if (n_below == 0)
      continue;
    const Kernels::Out panel = of_panel(k), below = panel.from(block, 0);
    Kernels::multiply_by_transposed(n_below, block, panel, below);
    Kernels::In left = below;
    if (negative.size() > n_negative_before)
    {
      const auto turn_back = [&](double *const first_row)
      {
        for (std::size_t n = n_negative_before; n < negative.size(); ++n)
          for (int i = 0; i < n_below; ++i)
            first_row[i + (negative[n] - own.first) * below.stride] *= -1.;
      };
      turn_back(below.data);
      turned.assign(panel.data, panel.data + static_cast<std::size_t>(own.height()) * block);
      left = {turned.data() + block, below.stride};
      turn_back(turned.data() + block);
    }
    parallel_for((n_below + block - 1) / block, 4,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t j = begin; j < end; ++j)
                   {
                     const int skip = j * block;
                     Kernels::subtract_product(n_below - skip, std::min(block, n_below - skip), block,
                                               left.from(skip, 0), below.from(skip, 0), of_panel(k + 1 + j));
                   }
                 });
  }
  return true;
}

void BandedSolver::forward(double *x) const
{
  double own[largest_block];
  for (int k = 0; k < n_panels; ++k)
  {
    const Kernels::In panel = of_panel(k);
    double *const here = x + panels[k].first;
    std::fill_n(own, block, 0.);
    Kernels::subtract_times(block, block, panel, here, own);
    for (int i = 0; i < block; ++i)
      here[i] = -own[i];
    Kernels::subtract_times(panels[k].height() - block, block, panel.from(block, 0), here, here + block);
  }
}

void BandedSolver::backward(double *x) const
{
  double own[largest_block];
  for (int k = n_panels - 1; k >= 0; --k)
  {
    const Kernels::In panel = of_panel(k);
    double *const here = x + panels[k].first;
    Kernels::subtract_transposed_times(panels[k].height() - block, block, panel.from(block, 0), here + block,
                                       here);
    std::fill_n(own, block, 0.);
    Kernels::subtract_transposed_times(block, block, panel, here, own);
    for (int i = 0; i < block; ++i)
      here[i] = -own[i];
  }
}

void BandedSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  Eigen::VectorXd y(n_panels * block);
  y.tail(y.size() - b.size()).setZero();
  for (int i = 0; i < b.size(); ++i)
    y[order[i]] = factor * b[i];
  forward(y.data());
  for (const int i : negative)
    y[i] = -y[i];
  backward(y.data());
  x.resize(b.size());
  for (int i = 0; i < b.size(); ++i)
    x[i] = y[order[i]];
}

void BandedSolver::condense(const Rows &rows, Eigen::MatrixXd &W)
{
  // W = Z S Z^T with Z = H P^T L^-T: half of the work of full solves, and symmetric by construction. A row of
  // Z begins where that of H does: those that begin first come first, and of a panel the first rows do.
  const int n = rows.cols(), n_padded = Kernels::filled(n);
  std::vector<int> begins(n, n_panels * block - 1), place(n);
  for (int c = 0; c < n; ++c)
    for (Rows::InnerIterator entry(rows, c); entry; ++entry)
      begins[c] = std::min(begins[c], order[entry.row()]);
  std::iota(place.begin(), place.end(), 0);
  std::sort(place.begin(), place.end(),
            [&](const int c, const int d) { return begins[c] != begins[d] ? begins[c] < begins[d] : c < d; });
  std::vector<int> begun(n_panels, 0); // rows, up to and with a panel
  for (int k = 0, r = 0; k < n_panels; ++k)
  {
    while (r < n && begins[place[r]] < (k + 1) * block)
      ++r;
    begun[k] = Kernels::filled(r);
  }
  Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(n_padded, n_panels * block);
  parallel_for(n_padded, rows_at_once,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (int r = begin; r < std::min<int>(end, n); ++r)
                   for (Rows::InnerIterator entry(rows, place[r]); entry; ++entry)
                     Z(r, order[entry.row()]) = entry.value();
                 for (int k = 0; k < n_panels; ++k)
                 {
                   const int n_here = std::min<int>(begun[k], end) - static_cast<int>(begin);
                   if (n_here <= 0)
                     continue;
                   const Kernels::In panel = of_panel(k);
                   const Kernels::Out own = {&Z(begin, panels[k].first), Z.outerStride()};
                   Kernels::multiply_by_transposed(n_here, block, panel, own);
                   Kernels::subtract_product(n_here, panels[k].height() - block, block, own,
                                             panel.from(block, 0), own.from(0, block));
                 }
               });
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(n_padded, n_padded);
  for (int k = 0; k < n_panels; k += panels_at_once)
  {
    const int end = std::min(k + panels_at_once, n_panels);
    Kernels::add_square(begun[end - 1], (end - k) * block, {&Z(0, k * block), Z.outerStride()},
                        {square.data(), square.outerStride()});
  }
  for (const int i : negative)
    square.selfadjointView<Eigen::Lower>().rankUpdate(Z.col(i), -2.);
  W.resize(n, n);
  for (int c = 0; c < n; ++c)
    for (int r = c; r < n; ++r)
      W(place[r], place[c]) = W(place[c], place[r]) = factor * square(r, c);
}
} // namespace softgrain
