// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/linear/linear_solver_kind.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace softgrain
{
namespace
{
namespace Wrappers = dealii::TrilinosWrappers;

/// The lower triangle of a body's matrix as a full Trilinos matrix of this process alone.
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
    if (source.pattern_is_new())
    {
      lay_out(lower);
      source.clear_pattern_flag();
    }
    fill(lower);
    prepare(source);
    return true;
  }

  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override
  {
    std::copy(b.begin(), b.end(), right.begin());
    solution = 0.;
    if (right.l2_norm() > 0.)
      apply();
    x.resize(b.size());
    std::copy(solution.begin(), solution.end(), x.begin());
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

  dealii::IndexSet all;
  Wrappers::SparseMatrix matrix;
  Wrappers::MPI::Vector right, solution;

private:
  void lay_out(const SystemMatrix::Sparse &lower)
  {
    dealii::DynamicSparsityPattern pattern(lower.rows(), lower.rows());
    for (int j = 0; j < lower.outerSize(); ++j)
      for (SystemMatrix::Sparse::InnerIterator entry(lower, j); entry; ++entry)
      {
        pattern.add(entry.row(), j);
        pattern.add(j, entry.row());
      }
    all = dealii::complete_index_set(lower.rows());
    matrix.reinit(all, pattern, MPI_COMM_SELF, false);
    right.reinit(all, MPI_COMM_SELF);
    solution.reinit(all, MPI_COMM_SELF);
  }

  /// Writes where Epetra keeps the values: adding entries one by one takes longer than multigrid.
  void fill(const SystemMatrix::Sparse &lower)
  {
    int *start, *columns;
    double *values;
    AssertThrow(matrix.trilinos_matrix().ExtractCrsDataPointers(start, columns, values) == 0,
                dealii::ExcInternalError());
    // Going through the columns of the lower triangle fills every row of the full matrix from left to right.
    std::vector<int> next(start, start + lower.rows());
    const auto put = [&](const int row, const int column, const double value)
    {
      AssertThrow(columns[next[row]] == column, dealii::ExcInternalError());
      values[next[row]++] = value;
    };
    for (int j = 0; j < lower.outerSize(); ++j)
      for (SystemMatrix::Sparse::InnerIterator entry(lower, j); entry; ++entry)
      {
        put(j, entry.row(), entry.value());
        if (entry.row() != j)
          put(entry.row(), j, entry.value());
      }
  }
};

class TrilinosDirect final : public TrilinosBase
{
  void prepare(const SystemMatrix &) override
  {
    solver = std::make_unique<Wrappers::SolverDirect>(control);
    solver->initialize(matrix);
  }
  void apply() override { solver->solve(solution, right); }

  dealii::SolverControl control;
  std::unique_ptr<Wrappers::SolverDirect> solver;
};

class TrilinosCg final : public TrilinosBase
{
public:
  TrilinosCg(const LinearSolverSettings &settings, const bool amg, const unsigned int dim)
      : settings(settings), use_amg(amg), dim(dim)
  {
  }

private:
  void prepare(const SystemMatrix &source) override
  {
    if (use_amg)
    {
      Wrappers::PreconditionAMG::AdditionalData data;
      data.elliptic = true;
      data.higher_order_elements = true;
      data.smoother_sweeps = 2;
      data.aggregation_threshold = 0.02;
      Teuchos::ParameterList parameters;
      std::unique_ptr<Epetra_MultiVector> no_modes;
      data.set_parameters(parameters, no_modes, matrix);
      // Without the rotations among what the coarse grids reproduce the number of iterations grows with the
      // size.
      motions = source.rigid_motions();
      parameters.set("PDE equations", static_cast<int>(dim));
      parameters.set("null space: type", "pre-computed");
      parameters.set("null space: dimension", static_cast<int>(motions.cols()));
      parameters.set("null space: vectors", motions.data());
      amg.initialize(matrix, parameters);
    }
    else
      ilu.initialize(matrix, Wrappers::PreconditionILU::AdditionalData(1, 0., 1., 0));
  }

  void apply() override
  {
    dealii::SolverControl control(settings.max_iterations, settings.tolerance * right.l2_norm());
    dealii::SolverCG<Wrappers::MPI::Vector> cg(control);
    try
    {
      if (use_amg)
        cg.solve(matrix, solution, right, amg);
      else
        cg.solve(matrix, solution, right, ilu);
    }
    catch (const dealii::SolverControl::NoConvergence &)
    {
      throw ComputationError(
          "conjugate gradients did not converge in " + std::to_string(settings.max_iterations) +
          " iterations ('Linear solver/Maximum iterations'); 'Linear solver/Type' = 'cholesky' always does");
    }
  }

  const LinearSolverSettings settings;
  const bool use_amg;
  const unsigned int dim;
  Eigen::MatrixXd motions;
  Wrappers::PreconditionAMG amg;
  Wrappers::PreconditionILU ilu;
};

class DirectKind final : public LinearSolverKind
{
public:
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &, unsigned int) const override
  {
    return std::make_unique<TrilinosDirect>();
  }
};

template <bool use_amg>
class CgKind final : public LinearSolverKind
{
public:
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &settings,
                                       const unsigned int dim) const override
  {
    return std::make_unique<TrilinosCg>(settings, use_amg, dim);
  }
};

template <class Kind>
bool add(const std::string &name, const std::string &description)
{
  return Registry<LinearSolverKind>::instance().add(name, description,
                                                    [] { return std::make_unique<Kind>(); });
}

[[maybe_unused]] const bool registered[] = {
    add<DirectKind>("trilinos_direct", "Amesos of Trilinos"),
    add<CgKind<false>>("cg_ilu", "conjugate gradients of Trilinos with an incomplete factorisation"),
    add<CgKind<true>>("cg_amg", "the same with algebraic multigrid (ML), for large bodies without contact")};
} // namespace
} // namespace softgrain
