// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of rays for given sides of their conditions.
#include <softgrain/mpm/contact/frame_system.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// Corrections of a solution, until GMRES takes over.
constexpr unsigned int most_refined = 3;

/// A function that stands for a matrix where SolverGMRES asks for products.
template <class Function>
struct Product
{
  Function function;
  void vmult(dealii::Vector<double> &to, const dealii::Vector<double> &from) const
  {
    const Eigen::Map<const Eigen::VectorXd> given(from.begin(), from.size());
    Eigen::Map<Eigen::VectorXd>(to.begin(), to.size()) = function(Eigen::VectorXd(given));
  }
};
template <class Function>
Product(Function) -> Product<Function>;

/// Solves A x = b. @param by the preconditioner @return whether it has
template <class Apply, class Precondition>
bool solve_by_gmres(const Apply &A,
                    const Precondition &by,
                    const Eigen::VectorXd &b,
                    dealii::SolverControl &control,
                    const unsigned int restart,
                    Eigen::VectorXd &x)
{
  dealii::Vector<double> right(b.begin(), b.end()), found(b.size());
  try
  {
    dealii::SolverGMRES<dealii::Vector<double>> solver(
        control, dealii::SolverGMRES<dealii::Vector<double>>::AdditionalData(restart));
    solver.solve(A, found, right, by);
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    return false;
  }
  x = Eigen::Map<const Eigen::VectorXd>(found.begin(), found.size());
  return true;
}
} // namespace

template <int dim>
bool FrameSystem<dim>::factorize_blocks(const bool plain, const bool with_slip)
{
  fills_plain = plain;
  fills_slip = with_slip;
  knows_inertia = false;
  std::vector<int> sizes(n_blocks, 0);
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      ++sizes[block_of[i]];
  if (fills_plain)
    factor.reinit(sizes, neighbours);
  if (fills_slip)
    slip_factor.reinit(sizes, neighbours, false);
  for (const auto &entry : own)
  {
    const unsigned int i = entry.row(), j = entry.col();
    add_entry(i, j, entry.value());
    // What slips gives to walls under loads.
    if (fills_slip && number[j] >= 0 && slips_with_force(i))
      add_slip(j, columns[i].mate, slips(i) * columns[i].bound * entry.value());
  }
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (give_of(i) != 0.)
      add_entry(i, i, give_of(i));
  for (unsigned int b = 0; b < of_body.size(); ++b)
    add_body(b);
  if (fills_plain)
  {
    if (!factor.factorize())
      return false;
    negative = factor.n_negative();
    knows_inertia = true;
  }
  return !fills_slip || slip_factor.factorize();
}

template <int dim>
bool FrameSystem<dim>::factorize_active()
{
  any_slips = false;
  for (unsigned int i = 0; i < columns.size(); ++i)
    any_slips = any_slips || slips_with_force(i);
  return factorize_blocks(wants_inertia || !any_slips, any_slips);
}

template <int dim>
bool FrameSystem<dim>::find_inertia()
{
  return knows_inertia || factorize_blocks(true, false);
}

/// Adds an entry of a frame's own, or of a frame and a wall under a load, and its mirror image.
template <int dim>
void FrameSystem<dim>::add_entry(const unsigned int i, const unsigned int j, const double value)
{
  if (number[i] < 0 || number[j] < 0)
    return;
  // The later one stands in the later block.
  const int row = std::max(number[i], number[j]), column = std::min(number[i], number[j]);
  const int row_block = std::max(block_of[i], block_of[j]), column_block = std::min(block_of[i], block_of[j]);
  const std::vector<int> &first = first_of_blocks();
  if (fills_plain)
    factor.block(row_block, column_block)(row - first[row_block], column - first[column_block]) += value;
  if (!fills_slip)
    return;
  add_slip(i, j, value);
  if (i != j)
    add_slip(j, i, value);
}

/// Adds to the matrix with friction that slips, in the row of @p i and the column of @p j.
template <int dim>
void FrameSystem<dim>::add_slip(const unsigned int i, const unsigned int j, const double value)
{
  const std::vector<int> &first = slip_factor.first();
  const int row_block = block_of[i], column_block = block_of[j], row = number[i] - first[row_block],
            column = number[j] - first[column_block];
  if (row_block >= column_block)
    slip_factor.block(row_block, column_block)(row, column) += value;
  else
    slip_factor.transposed_block(column_block, row_block)(column, row) += value;
}

/// Adds W of a body, block by block.
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
    unsigned int begin, end; ///< of its entries
  };
  const std::vector<unsigned int> &list = of_body[b];
  // They keep their memory from body to body.
  static thread_local std::vector<Entry> entries;
  static thread_local std::vector<Part> parts;
  entries.clear();
  parts.clear();
  for (unsigned int i = 0; i < list.size(); ++i)
    if (const Column &column = columns[list[i]]; number[list[i]] >= 0)
    {
      const int block = block_of[list[i]];
      if (parts.empty() || parts.back().block != block)
        parts.push_back({block, static_cast<unsigned int>(entries.size()), 0});
      Entry entry{static_cast<int>(i), number[list[i]] - first_of_blocks()[block], -1, 0.};
      if (const unsigned int slide = column.mate;
          column.kind == Column::ray && slide != Column::none && slips_with_force(slide))
      {
        entry.slide = place_in(list, slide);
        entry.factor = slips(slide) * columns[slide].bound;
      }
      entries.push_back(entry);
      parts.back().end = entries.size();
    }
  const auto without = [&](const Entry &row, const Entry &column) { return W[b](row.in_W, column.in_W); };
  const auto with_slip = [&](const Entry &row, const Entry &column)
  {
    return column.slide < 0 ? without(row, column)
                            : without(row, column) + column.factor * W[b](row.in_W, column.slide);
  };
  const auto add = [](auto block, const Part &rows, const Part &of_columns, const auto &value)
  {
    for (unsigned int j = of_columns.begin; j < of_columns.end; ++j)
      for (unsigned int i = rows.begin; i < rows.end; ++i)
        block(entries[i].in_block, entries[j].in_block) += value(entries[i], entries[j]);
  };
  for (const Part &one : parts)
    for (const Part &other : parts)
    {
      if (one.block < other.block)
        continue;
      if (fills_plain)
        add(factor.block(one.block, other.block), one, other, without);
      if (!fills_slip)
        continue;
      add(slip_factor.block(one.block, other.block), one, other, with_slip);
      if (one.block != other.block)
        add(slip_factor.transposed_block(one.block, other.block), one, other,
            [&](const Entry &column, const Entry &row) { return with_slip(row, column); });
    }
}

/// In dense blocks: in space a contact has dozens of columns, and in the plane a dozen.
template <int dim>
bool FrameSystem<dim>::solve_active()
{
  number_unknowns();
  return factorize_active() && solve_with_factors(true);
}

template <int dim>
bool FrameSystem<dim>::solve_with_factors(const bool exactly)
{
  const Eigen::VectorXd b = right_of_unknowns();
  // What unknowns do, with friction that goes with them where it slips.
  const auto apply = [&](const Eigen::VectorXd &of_unknowns)
  {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(columns.size()), result(n_unknowns);
    for (unsigned int i = 0; i < columns.size(); ++i)
      if (number[i] >= 0)
        all[i] = of_unknowns[number[i]];
    for (unsigned int i = 0; i < columns.size() && any_slips; ++i)
      if (slips_with_force(i))
        all[i] = slips(i) * columns[i].bound * all[columns[i].mate];
    Eigen::VectorXd here = Eigen::VectorXd::Zero(columns.size());
    add_effect(all, here);
    for (unsigned int i = 0; i < columns.size(); ++i)
      if (number[i] >= 0)
        result[number[i]] = here[i];
    return result;
  };
  const auto solve_nearly = [&](Eigen::VectorXd of_rows)
  {
    (any_slips ? slip_factor : factor).solve(of_rows);
    return of_rows;
  };
  if (!any_slips)
  {
    Eigen::VectorXd x = solve_nearly(b);
    x += solve_nearly(b - apply(x));
    return take_unknowns(x);
  }
  if (!exactly)
    return take_unknowns(solve_nearly(b));
  // GMRES adds up squares: all equations become those of ways, and all unknowns too.
  const std::array<Eigen::VectorXd, 2> units = units_of_unknowns();
  const Eigen::VectorXd &of_rows = units[0], &of_columns = units[1], scaled = of_rows.cwiseProduct(b);
  const Product matrix{[&](const Eigen::VectorXd &y)
                       { return Eigen::VectorXd(of_rows.cwiseProduct(apply(of_columns.cwiseProduct(y)))); }};
  const Product near{[&](const Eigen::VectorXd &y) {
    return Eigen::VectorXd(solve_nearly(y.cwiseQuotient(of_rows)).cwiseQuotient(of_columns));
  }};
  Eigen::VectorXd y = near.function(scaled);
  const double tolerance = gmres_tolerance * y.norm();
  // The factors are those of the matrix: once or twice is enough, but where pivots are small.
  for (unsigned int n_refined = 0; n_refined < most_refined; ++n_refined)
  {
    const Eigen::VectorXd more = near.function(scaled - matrix.function(y));
    y += more;
    if (more.norm() <= tolerance)
      return take_unknowns(of_columns.cwiseProduct(y));
  }
  dealii::SolverControl control(gmres_iterations, tolerance, false, false);
  if (!solve_by_gmres(matrix, near, scaled, control, gmres_restart, y))
    return false;
  y += near.function(scaled - matrix.function(y));
  return take_unknowns(of_columns.cwiseProduct(y));
}

template bool FrameSystem<2>::find_inertia();
template bool FrameSystem<3>::find_inertia();
template bool FrameSystem<3>::factorize_active();
template bool FrameSystem<2>::solve_active();
template bool FrameSystem<3>::solve_active();
template bool FrameSystem<3>::solve_with_factors(bool);
} // namespace softgrain::mpm
