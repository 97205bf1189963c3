// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/linear/banded_solver.h>

#include <Eigen/Cholesky>

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
using Panel = Eigen::Map<Eigen::MatrixXd>;

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
  band = (width + block - 1) / block * block;
  n_panels = (matrix.rows() + block - 1) / block;
  panels.assign(static_cast<std::size_t>(n_panels) * (block + band) * block, 0.);
  target.resize(matrix.nonZeros());
  std::size_t k = 0;
  for (int j = 0; j < matrix.outerSize(); ++j)
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry, ++k)
    {
      const int row = std::max(order[entry.row()], order[j]), column = std::min(order[entry.row()], order[j]);
      const int panel = column / block;
      target[k] =
          panel * (block + band) * block + (column - panel * block) * (block + band) + (row - panel * block);
    }
}

void BandedSolver::fill(const Sparse &matrix)
{
  std::fill(panels.begin(), panels.end(), 0.);
  const double *values = matrix.valuePtr();
  for (std::size_t k = 0; k < target.size(); ++k)
    panels[target[k]] += values[k];
  // The last panel may reach beyond the matrix: ones on the diagonal leave the rest alone.
  for (int i = matrix.rows(); i < n_panels * block; ++i)
  {
    const int column = i - (n_panels - 1) * block;
    panels[static_cast<std::size_t>(n_panels - 1) * (block + band) * block + column * (block + band) +
           column] = 1.;
  }
}

/// Diagonal block L S L^T in place, S a sign for every column. All signs are + in almost every case, and then
/// it is Cholesky's factor.
bool BandedSolver::factorize_diagonal(const int panel)
{
  Panel whole(&panels[static_cast<std::size_t>(panel) * (block + band) * block], block + band, block);
  Eigen::Matrix<double, block, block> L = whole.topRows(block);
  const Eigen::LLT<Eigen::Ref<Eigen::Matrix<double, block, block>>> llt(L);
  if (llt.info() != Eigen::Success)
  {
    // Without pivoting, as the band asks for.
    L = whole.topRows(block);
    Eigen::Matrix<double, block, 1> sign;
    for (int j = 0; j < block; ++j)
    {
      double pivot = L(j, j);
      for (int i = 0; i < j; ++i)
        pivot -= sign[i] * L(j, i) * L(j, i);
      if (!(std::abs(pivot) > 1e-12 * std::abs(L(j, j))))
        return false;
      sign[j] = pivot > 0. ? 1. : -1.;
      if (pivot < 0.)
        negative.push_back(panel * block + j);
      if (negative.size() > 1)
        return false;
      L(j, j) = std::sqrt(std::abs(pivot));
      for (int r = j + 1; r < block; ++r)
      {
        double value = L(r, j);
        for (int i = 0; i < j; ++i)
          value -= sign[i] * L(r, i) * L(j, i);
        L(r, j) = value * sign[j] / L(j, j);
      }
    }
  }
  whole.topRows(block) = L;
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
  const std::size_t size = static_cast<std::size_t>(block + band) * block;
  for (int k = 0; k < n_panels; ++k)
  {
    const std::size_t n_negative_before = negative.size();
    if (!factorize_diagonal(k))
      return false;
    Panel panel(&panels[k * size], block + band, block);
    const int n_below = std::min(band / block, n_panels - 1 - k);
    if (n_below == 0)
      continue;
    auto below = panel.middleRows(block, n_below * block);
    panel.topRows(block).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    Eigen::MatrixXd turned; // L21 S, of a panel with a negative pivot
    if (negative.size() > n_negative_before)
    {
      below.col(negative.back() - k * block) *= -1.;
      turned = below;
      turned.col(negative.back() - k * block) *= -1.;
    }
    parallel_for(n_below, 4,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t j = begin; j < end; ++j)
                   {
                     const int rows = (n_below - static_cast<int>(j)) * block;
                     Panel next(&panels[(k + 1 + j) * size], block + band, block);
                     const auto right = below.middleRows(j * block, block).transpose();
                     if (turned.size() > 0)
                       next.topRows(rows).noalias() -= turned.bottomRows(rows) * right;
                     else
                       next.topRows(rows).noalias() -= below.bottomRows(rows) * right;
                   }
                 });
  }
  return true;
}

template <class Derived>
void BandedSolver::forward(Eigen::MatrixBase<Derived> &x) const
{
  const std::size_t size = static_cast<std::size_t>(block + band) * block;
  for (int k = 0; k < n_panels; ++k)
  {
    const Eigen::Map<const Eigen::MatrixXd> panel(&panels[k * size], block + band, block);
    auto own = x.middleRows(k * block, block);
    panel.topRows(block).triangularView<Eigen::Lower>().solveInPlace(own);
    const int rows = std::min(band, (n_panels - 1 - k) * block);
    if (rows > 0)
      x.middleRows((k + 1) * block, rows).noalias() -= panel.middleRows(block, rows) * own;
  }
}

template <class Derived>
void BandedSolver::backward(Eigen::MatrixBase<Derived> &x) const
{
  const std::size_t size = static_cast<std::size_t>(block + band) * block;
  for (int k = n_panels - 1; k >= 0; --k)
  {
    const Eigen::Map<const Eigen::MatrixXd> panel(&panels[k * size], block + band, block);
    auto own = x.middleRows(k * block, block);
    const int rows = std::min(band, (n_panels - 1 - k) * block);
    if (rows > 0)
      own.noalias() -= panel.middleRows(block, rows).transpose() * x.middleRows((k + 1) * block, rows);
    panel.topRows(block).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
}

void BandedSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n_panels * block);
  for (int i = 0; i < b.size(); ++i)
    y[order[i]] = b[i];
  forward(y);
  for (const int i : negative)
    y[i] = -y[i];
  backward(y);
  x.resize(b.size());
  for (int i = 0; i < b.size(); ++i)
    x[i] = y[order[i]];
}

void BandedSolver::condense(const Rows &rows, Eigen::MatrixXd &W)
{
  // W = Y^T S Y with L Y = P H^T: half of the work of full solves, and symmetric by construction.
  Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(n_panels * block, rows.cols());
  parallel_for(rows.cols(), 16,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t c = begin; c < end; ++c)
                   for (Rows::InnerIterator entry(rows, c); entry; ++entry)
                     Y(order[entry.row()], c) = entry.value();
                 auto own = Y.middleCols(begin, end - begin);
                 forward(own);
               });
  W.setZero(rows.cols(), rows.cols());
  W.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose());
  for (const int i : negative)
    W.selfadjointView<Eigen::Lower>().rankUpdate(Eigen::VectorXd(Y.row(i).transpose()), -2.);
  W.triangularView<Eigen::StrictlyUpper>() = W.transpose();
}
} // namespace softgrain
