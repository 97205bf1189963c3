// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of rays for given columns: which are closed, which stick and which slip.
#include <softgrain/mpm/contact/frame_system.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int most_passes = 40;
/// After sets have repeated only rays change sides that are wrong by that share of the worst.
constexpr double share_of_worst = 0.5;
/// In space sets of sides may repeat for ever where a ray hardly presses. Newton's method goes on from what
/// is wrong by no more than this share of the largest force.
constexpr double wrong_that_may_be = 1e-2;
constexpr double farthest = 5.;            ///< gap or slide of a step that may be [cells]
constexpr double usual_strain = 1. / 4096; ///< of a force over stiffness and way, where both count alike
constexpr unsigned int base_of_gmres = 60, most_of_gmres = 200;
constexpr double tolerance_of_gmres = 1e-12;
constexpr unsigned int most_in_saddle = 3; ///< passes in which a set may belong to no minimum

/// One that SolverGMRES may ask for products.
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

/// Solves A x = b. @param by solves nearly. @return whether it has
template <class Apply, class Precondition>
bool solve_by_gmres(const Apply &A, const Precondition &by, const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
  dealii::Vector<double> right(b.begin(), b.end()), found(b.size());
  dealii::SolverControl control(most_of_gmres, tolerance_of_gmres * by.function(b).norm(), false, false);
  try
  {
    dealii::SolverGMRES<dealii::Vector<double>> solver(
        control, dealii::SolverGMRES<dealii::Vector<double>>::AdditionalData(base_of_gmres));
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

// In the plane: frame_solve_plane.cc.
template <>
bool FrameSystem<2>::solve_active();

template <int dim>
bool FrameSystem<dim>::solve_active()
{
  if (!factorize_active())
    return false;
  n_free = 0;
  for (const FreeWay<dim> &way : ways)
    n_free += way.stopped == 0;
  const Eigen::VectorXd known = set_known() ? Eigen::VectorXd(-beyond()) : right;
  const int n = factor.first().back();
  Eigen::VectorXd b(n), x;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      b[number[i]] = known[i];
  // What unknowns do, with friction that goes with them where it slips.
  const auto apply = [&](const Eigen::VectorXd &of_unknowns)
  {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(columns.size()), result(n);
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
    x = solve_nearly(b);
    x += solve_nearly(b - apply(x));
  }
  else
  {
    // GMRES adds up squares: all equations become those of ways, and all unknowns too.
    Eigen::VectorXd of_rows(n), of_columns(n);
    const double unit = unit_of_forces();
    for (unsigned int i = 0; i < columns.size(); ++i)
      if (number[i] >= 0)
      {
        const bool is_way = columns[i].kind == Column::wall || columns[i].kind == Column::motion;
        of_rows[number[i]] = is_way ? 1. / unit : 1.;
        of_columns[number[i]] = is_way ? 1. : unit;
      }
    const Product matrix{[&](const Eigen::VectorXd &y) {
      return Eigen::VectorXd(of_rows.cwiseProduct(apply(of_columns.cwiseProduct(y))));
    }};
    const Product near{[&](const Eigen::VectorXd &y) {
      return Eigen::VectorXd(solve_nearly(y.cwiseQuotient(of_rows)).cwiseQuotient(of_columns));
    }};
    if (!solve_by_gmres(matrix, near, of_rows.cwiseProduct(b), x))
      return false;
    x += near.function(of_rows.cwiseProduct(b) - matrix.function(x));
    x = of_columns.cwiseProduct(x);
  }
  if (!x.allFinite())
    return false;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      z[i] = x[number[i]];
  for (unsigned int i = 0; i < columns.size() && any_slips; ++i)
    if (slips_with_force(i))
      z[i] = slips(i) * columns[i].bound * (z[columns[i].mate] + columns[columns[i].mate].pull);
  return true;
}

template <int dim>
double FrameSystem<dim>::unit_of_forces() const
{
  double stiffest = 0.;
  for (const Column &column : columns)
    stiffest = std::max(stiffest, column.stiffness);
  return usual_strain * std::exp2(std::ilogb(stiffest));
}

template <int dim>
bool FrameSystem<dim>::set_known()
{
  z.setZero();
  bool any = false;
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    const bool bounded = by_threshold && active[i] && slips(i) != 0,
               stopped = columns[i].kind == Column::wall && ways[i].stopped != 0;
    if (bounded)
      z[i] = slips(i) * columns[i].threshold;
    // What adhesion adds to the friction that slips, and all that it leaves to a ray that opens.
    else if (active[i] && slips(i) != 0)
      z[i] = slips(i) * columns[i].bound * columns[columns[i].mate].pull;
    else if (!active[i] && columns[i].kind == Column::ray)
      z[i] = -columns[i].pull;
    if (stopped)
      z[i] = ways[i].stopped * ways[i].limit - ways[i].at;
    any = any || z[i] != 0. || stopped;
  }
  return any;
}

template <int dim>
Eigen::VectorXd FrameSystem<dim>::beyond() const
{
  Eigen::VectorXd here = -right;
  add_effect(z, here);
  return here;
}

template <int dim>
void FrameSystem<dim>::add_effect(const Eigen::VectorXd &all, Eigen::VectorXd &here) const
{
  Eigen::VectorXd of_columns, effect;
  for (unsigned int b = 0; b < of_body.size(); ++b)
    if (!of_body[b].empty())
    {
      of_columns.resize(of_body[b].size());
      for (unsigned int i = 0; i < of_body[b].size(); ++i)
        of_columns[i] = all[of_body[b][i]];
      effect.noalias() = W[b] * of_columns;
      for (unsigned int i = 0; i < of_body[b].size(); ++i)
        here[of_body[b][i]] += effect[i];
    }
  for (const auto &entry : own)
  {
    here[entry.col()] += entry.value() * all[entry.row()];
    if (entry.row() != entry.col())
      here[entry.row()] += entry.value() * all[entry.col()];
  }
  for (unsigned int i = 0; i < columns.size(); ++i)
    here[i] += give_of(i) * all[i];
}

/// By how much rays are where they must not be, as forces. @return whether any is
template <int dim>
bool FrameSystem<dim>::find_wrong(const Eigen::VectorXd &here, const double cell_size)
{
  largest = 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray || columns[i].kind == Column::slide)
      largest = std::max(largest, std::abs(z[i]));
  wrong.setZero(columns.size());
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    const bool sticks = slips(i) == 0;
    const double as_force = here[i] * columns[i].stiffness;
    double amount = 0., allowed = 1e-10 * cell_size * columns[i].stiffness;
    if (columns[i].kind == Column::ray)
      amount = active[i] ? -(z[i] + columns[i].pull) : -as_force;
    else if (columns[i].kind == Column::slide && columns[i].component == 0 && active[i])
      amount = sticks ? found_friction(i).norm() - most_friction(i)
                      : std::max(slips(i) * as_force, off_direction(i));
    if (active[i] && sticks)
      allowed = 1e-10 * largest;
    if (amount > allowed)
      wrong[i] = amount;
  }
  worst = wrong.size() > 0 ? wrong.maxCoeff() : 0.;
  return worst > 0.;
}

template <int dim>
void FrameSystem<dim>::change_sides(const Eigen::VectorXd &here, const double share)
{
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (wrong[i] > 0. && wrong[i] >= share * worst)
    {
      if (columns[i].kind == Column::slide)
        change_slip(here, i);
      else
      {
        active[i] = !active[i];
        for (unsigned int m = 0; m < dim - 1 && columns[i].mate != Column::none; ++m)
          active[columns[i].mate + m] = active[i];
      }
    }
    else if (dim == 3 && slips(i) != 0 && active[i])
      change_slip(here, i);
}

template <int dim>
bool FrameSystem<dim>::walls_stay(const Eigen::VectorXd &here)
{
  bool all_stay = true;
  for (unsigned int w = 0; w < ways.size(); ++w)
  {
    // One at its stop goes back where what it meets bears more than its load.
    int &stopped = ways[w].stopped;
    const int before = stopped;
    const double way = ways[w].at + z[w];
    if (before == 0 && std::abs(way) > ways[w].limit)
      stopped = way > 0. ? 1 : -1;
    else if (before * here[w] < 0.)
      stopped = 0;
    all_stay = all_stay && stopped == before;
  }
  return all_stay;
}

template <int dim>
std::vector<signed char> FrameSystem<dim>::sides() const
{
  std::vector<signed char> result(columns.size());
  for (unsigned int i = 0; i < columns.size(); ++i)
    result[i] = columns[i].kind == Column::wall ? 2 + ways[i].stopped : active[i] ? 2 + slips(i) : 0;
  return result;
}

template <int dim>
double FrameSystem<dim>::farthest_way(const Eigen::VectorXd &here) const
{
  double way = 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray || columns[i].kind == Column::slide)
      way = std::max(way, std::abs(here[i]));
  return way;
}

template <int dim>
bool FrameSystem<dim>::settle(const double cell_size, const unsigned int negative_of_bodies)
{
  bool settled = false, repeats = false;
  std::set<std::vector<signed char>> seen{sides()};
  for (unsigned int pass = 0; pass < most_passes && !settled; ++pass)
  {
    ++passes;
    if (!solve_active() || (pass >= most_in_saddle && wrong_inertia(negative_of_bodies) != 0))
      return false;
    const Eigen::VectorXd here = beyond();
    // Nothing holds the bodies: no set is right where they go so far.
    if (pass >= most_in_saddle && farthest_way(here) > farthest * cell_size)
      return false;
    const bool any_wrong = find_wrong(here, cell_size);
    settled = !any_wrong || (dim == 3 && any_slips && repeats && worst < wrong_that_may_be * largest);
    if (!settled)
      change_sides(here, repeats ? share_of_worst : 0.);
    if (!any_wrong)
      settled = walls_stay(here);
    repeats = repeats || !seen.insert(sides()).second;
  }
  return settled;
}

template <int dim>
bool FrameSystem<dim>::solve(const double cell_size, const unsigned int negative_of_bodies)
{
  right = -Eigen::Map<const Eigen::VectorXd>(gap.data(), gap.size());
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int i = 0; i < of_body[b].size(); ++i)
      right[of_body[b][i]] -= moved[b][i];
  by_threshold = false;
  bool settled = settle(cell_size, negative_of_bodies);
  if (!settled && wrong_inertia(negative_of_bodies) == 0 && any_slides)
  {
    // Friction that is bounded by the forces of the last iterate instead of these is a minimum, whose sets
    // settle.
    by_threshold = true;
    settled = settle(cell_size, negative_of_bodies);
  }
  found_ways.resize(ways.size());
  for (unsigned int w = 0; w < ways.size(); ++w)
    found_ways[w] = ways[w].at + z[w];
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
      found[columns[i].frame][columns[i].ray_number] = std::max(-columns[i].pull, z[i]);
    else if (columns[i].kind == Column::slide && columns[i].component == 0 && active[i])
      note_friction(i);
  return settled;
}

template bool FrameSystem<2>::set_known();
template Eigen::VectorXd FrameSystem<2>::beyond() const;
template double FrameSystem<2>::unit_of_forces() const;
template bool FrameSystem<2>::solve(double, unsigned int);
template bool FrameSystem<3>::solve(double, unsigned int);
} // namespace softgrain::mpm
