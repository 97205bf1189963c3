// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/linear/linear_solver_kind.h>

#include <deal.II/base/config.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <Teuchos_ParameterList.hpp>

#include <cmath>
#include <memory>
#include <mutex>
#include <numeric>
#include <vector>

namespace softgrain
{
namespace
{
namespace Wrappers = dealii::TrilinosWrappers;

/**
 * Held by who calls Trilinos. It counts the users of its objects, times its own work and asks MPI, none of
 * which is made for several threads: bodies that were solved at once ended in a segmentation fault now and
 * then.
 */
std::mutex &trilinos_in_use()
{
  static std::mutex mutex;
  return mutex;
}

/// The power of two that brings @p x to between 1 and 2, exactly.
double to_one(const double x)
{
  return x > 0. && std::isfinite(x) ? std::exp2(-std::ilogb(x)) : 1.;
}

/// The lower triangle of a body's matrix as a full Trilinos matrix of this process alone. Matrix and right
/// side are brought to numbers near 1 by powers of two, so Trilinos, whose thresholds have no unit, sees the
/// same bits in all units that are powers of two of each other.
class TrilinosBase : public LinearSolver
{
public:
  bool factorize(SystemMatrix &source) override
  {
    const SystemMatrix::Sparse &lower = source.lower();
    // A Cholesky solver would stop here too.
    for (int j = 0; j < lower.outerSize(); ++j)
      if (!(lower.valuePtr()[lower.outerIndexPtr()[j]] > 0.))
        return false;
    const std::lock_guard<std::mutex> lock(trilinos_in_use());
    if (source.pattern_is_new())
    {
      lay_out(lower);
      source.clear_pattern_flag();
    }
    scale = to_one(lower.valuePtr()[lower.outerIndexPtr()[0]]);
    fill(lower);
    prepare(source);
    return true;
  }

  std::optional<unsigned int> n_negative() const override { return std::nullopt; }

  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override
  {
    const std::lock_guard<std::mutex> lock(trilinos_in_use());
    const double of_right = to_one(b.lpNorm<Eigen::Infinity>());
    x = of_right * b;
    right.set(indices.size(), indices.data(), x.data());
    right.compress(dealii::VectorOperation::insert);
    solution = 0.;
    if (right.l2_norm() > 0.)
      apply();
    solution.extract_subvector_to(indices.begin(), indices.end(), x.data());
    x *= scale / of_right;
  }

  void condense(const Rows &rows, Eigen::MatrixXd &W) override
  {
    W.resize(rows.cols(), rows.cols());
    Eigen::VectorXd x;
    for (int c = 0; c < rows.cols(); ++c)
    {
      solve(Eigen::VectorXd(rows.col(c)), x);
      W.col(c) = rows.transpose() * x;
    }
    W = 0.5 * (W + W.transpose()).eval();
  }

protected:
  /// Makes ready for apply() what depends on the matrix.
  virtual void prepare(const SystemMatrix &source) = 0;
  /// solution = matrix^-1 right, starting from zero.
  virtual void apply() = 0;

  Wrappers::SparseMatrix matrix;
  Wrappers::MPI::Vector right, solution;

private:
  double scale = 1.; ///< of the matrix
  void lay_out(const SystemMatrix::Sparse &lower)
  {
    const int n = lower.rows();
    std::vector<std::size_t> length(n, 0);
    for (int j = 0; j < n; ++j)
      for (SystemMatrix::Sparse::InnerIterator entry(lower, j); entry; ++entry)
      {
        ++length[j];
        if (entry.row() != j)
          ++length[entry.row()];
      }
    begin_of_row.assign(n + 1, 0);
    std::partial_sum(length.begin(), length.end(), begin_of_row.begin() + 1);
    columns.resize(begin_of_row.back());
    values.resize(begin_of_row.back());
    by_row(lower, [this](const std::size_t place, const int column, double) { columns[place] = column; });

    dealii::DynamicSparsityPattern pattern(n, n);
    for (int i = 0; i < n; ++i)
      pattern.add_entries(i, columns.begin() + begin_of_row[i], columns.begin() + begin_of_row[i + 1], true);
    const dealii::IndexSet all = dealii::complete_index_set(n);
    matrix.reinit(all, pattern, MPI_COMM_SELF, false);
    right.reinit(all, MPI_COMM_SELF);
    solution.reinit(all, MPI_COMM_SELF);
    indices.resize(n);
    std::iota(indices.begin(), indices.end(), 0);
  }

  /// Row by row: entry by entry takes longer than multigrid.
  void fill(const SystemMatrix::Sparse &lower)
  {
    by_row(lower,
           [this](const std::size_t place, int, const double value) { values[place] = scale * value; });
    for (std::size_t i = 0; i < indices.size(); ++i)
      matrix.set(i, begin_of_row[i + 1] - begin_of_row[i], columns.data() + begin_of_row[i],
                 values.data() + begin_of_row[i], false);
    matrix.compress(dealii::VectorOperation::insert);
  }

  /// Calls put(place, column, value) for every entry of the full matrix, whose places go row by row.
  template <class Put>
  void by_row(const SystemMatrix::Sparse &lower, const Put &put) const
  {
    // Going through the columns of the lower triangle fills every row of the full matrix from left to right.
    std::vector<std::size_t> next(begin_of_row.begin(), begin_of_row.end() - 1);
    for (int j = 0; j < lower.outerSize(); ++j)
      for (SystemMatrix::Sparse::InnerIterator entry(lower, j); entry; ++entry)
      {
        put(next[j]++, entry.row(), entry.value());
        if (entry.row() != j)
          put(next[entry.row()]++, j, entry.value());
      }
  }

  using Index = dealii::types::global_dof_index;
  // The full matrix by rows.
  std::vector<std::size_t> begin_of_row;
  std::vector<Index> columns;
  std::vector<double> values;
  std::vector<Index> indices; ///< of all unknowns
};

/// Up to deal.II 9.7 multigrid is always ML, which is told the unknowns of a node, too. From 9.8 on it may be
/// MueLu, with other names of parameters, and only deal.II's own description serves both.
constexpr bool multigrid_is_ml = !DEAL_II_VERSION_GTE(9, 8, 0);

/// Multigrid for elasticity. @param motions rigid ones, by columns; they must live as long as @p amg
template <class Amg>
void prepare_multigrid(Amg &amg,
                       const Wrappers::SparseMatrix &matrix,
                       Eigen::MatrixXd &motions,
                       const unsigned int dim)
{
  // Without the rotations among what the coarse grids reproduce the number of iterations grows with the size.
  if constexpr (!multigrid_is_ml)
  {
    typename Amg::AdditionalData data;
    data.elliptic = true;
    data.higher_order_elements = true;
    data.smoother_sweeps = 2;
    data.aggregation_threshold = 0.02;
    for (Eigen::Index c = 0; c < motions.cols(); ++c)
      data.constant_modes_values.emplace_back(motions.col(c).begin(), motions.col(c).end());
    amg.initialize(matrix, data);
  }
  else
  {
    Teuchos::ParameterList parameters; // of ML
    parameters.set("default values", "SA");
    parameters.set("aggregation: type", "Uncoupled");
    parameters.set("aggregation: threshold", 0.02);
    parameters.set("smoother: type", "Chebyshev");
    parameters.set("smoother: sweeps", 2);
    parameters.set("smoother: Chebyshev alpha", 10.);
    parameters.set("coarse: type", "Amesos-KLU");
    parameters.set("coarse: max size", 2000);
    parameters.set("initialize random seed", true);
    parameters.set("ML output", 0);
    parameters.set("PDE equations", static_cast<int>(dim));
    parameters.set("null space: type", "pre-computed");
    parameters.set("null space: dimension", static_cast<int>(motions.cols()));
    parameters.set("null space: vectors", motions.data());
    amg.initialize(matrix, parameters);
  }
}

class TrilinosCg final : public TrilinosBase
{
public:
  TrilinosCg(const LinearSolverSettings &settings, const unsigned int dim) : settings(settings), dim(dim) {}

private:
  void prepare(const SystemMatrix &source) override
  {
    motions = source.rigid_motions();
    for (Eigen::Index c = 0; c < motions.cols(); ++c)
      motions.col(c) *= to_one(motions.col(c).lpNorm<Eigen::Infinity>());
    prepare_multigrid(amg, matrix, motions, dim);
  }

  void apply() override
  {
    dealii::SolverControl control(settings.max_iterations, settings.tolerance * right.l2_norm());
    // Its own vectors: those of deal.II's pool go from body to body, and outlive the lock.
    dealii::PrimitiveVectorMemory<Wrappers::MPI::Vector> memory;
    dealii::SolverCG<Wrappers::MPI::Vector> cg(control, memory);
    try
    {
      cg.solve(matrix, solution, right, amg);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      throw ComputationError(
          "conjugate gradients did not converge in " + std::to_string(settings.max_iterations) +
          " iterations ('Linear solver/Maximum iterations'); 'Linear solver/Type' = 'cholesky' always does");
    }
  }

  const LinearSolverSettings settings;
  const unsigned int dim;
  Eigen::MatrixXd motions;
  Wrappers::PreconditionAMG amg;
};

class CgKind final : public LinearSolverKind
{
public:
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &settings,
                                       const unsigned int dim) const override
  {
    return std::make_unique<TrilinosCg>(settings, dim);
  }
};

[[maybe_unused]] const bool registered = Registry<LinearSolverKind>::instance().add(
    "cg_amg",
    "conjugate gradients with algebraic multigrid (ML of Trilinos), for large bodies without contact",
    [] { return std::make_unique<CgKind>(); });
} // namespace
} // namespace softgrain
