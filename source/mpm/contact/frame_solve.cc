// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of rays for given columns: which are closed, which stick and which slip. The equations for given
// sides are solved in frame_solve_plane.cc and frame_solve_space.cc.
#include <softgrain/mpm/contact/frame_system.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace softgrain::mpm
{
namespace
{
/// After sets have repeated only rays change sides that are wrong by that share of the worst.
constexpr double share_of_worst = 0.5;
constexpr unsigned int most_in_saddle = 3; ///< passes in which a set may belong to no minimum
constexpr double usual_strain = 1. / 4096; ///< of a force over stiffness and way, where both count alike

/// A x, without the columns that x takes nothing of: with friction most are those of open rays.
void multiply_nonzeros(const Eigen::MatrixXd &A, const Eigen::VectorXd &x, Eigen::VectorXd &product)
{
  product.setZero(A.rows());
  for (int begin = 0, end; begin < x.size(); begin = end)
  {
    for (end = begin + 1; end < x.size() && (x[end] == 0.) == (x[begin] == 0.);)
      ++end;
    if (x[begin] != 0.)
      product.noalias() += A.middleCols(begin, end - begin) * x.segment(begin, end - begin);
  }
}
} // namespace

template <int dim>
void FrameSystem<dim>::number_unknowns()
{
  number.assign(columns.size(), -1);
  n_unknowns = 0;
  for (const unsigned int i : order)
    if (counts(i))
      number[i] = n_unknowns++;
}

template <int dim>
Eigen::VectorXd FrameSystem<dim>::right_of_unknowns()
{
  n_free = 0;
  for (const FreeWay<dim> &way : ways)
    n_free += way.stopped == 0;
  const Eigen::VectorXd known = set_known() ? Eigen::VectorXd(-beyond()) : right;
  Eigen::VectorXd of_unknowns(n_unknowns);
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      of_unknowns[number[i]] = known[i];
  return of_unknowns;
}

template <int dim>
std::array<Eigen::VectorXd, 2> FrameSystem<dim>::units_of_unknowns() const
{
  Eigen::VectorXd of_rows(n_unknowns), of_columns(n_unknowns);
  const double unit = unit_of_forces();
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
    {
      const bool is_way = columns[i].kind == Column::wall || columns[i].kind == Column::motion;
      of_rows[number[i]] = is_way ? 1. / unit : 1.;
      of_columns[number[i]] = is_way ? 1. : unit;
    }
  return {{of_rows, of_columns}};
}

template <int dim>
bool FrameSystem<dim>::take_unknowns(const Eigen::VectorXd &x)
{
  if (!x.allFinite())
    return false;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      z[i] = x[number[i]];
  for (unsigned int i = 0; i < columns.size(); ++i)
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
    if (columns[i].keeps)
      z[i] = columns[i].kept;
    else if (bounded)
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
      pick(b, all, of_columns);
      if (dim == 3 && any_slides)
        multiply_nonzeros(W[b], of_columns, effect);
      else
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
    else if (columns[i].kind == Column::slide && columns[i].component == 0 && active[i] && !columns[i].keeps)
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
void FrameSystem<dim>::change_sides(const double share)
{
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (wrong[i] > 0. && wrong[i] >= share * worst)
    {
      if (columns[i].kind == Column::slide)
      {
        signed char &slip = slipping[columns[i].frame][columns[i].ray_number];
        slip = slip != 0 ? 0 : z[i] > 0. ? 1 : -1;
      }
      else
      {
        active[i] = !active[i];
        for (unsigned int m = 0; m < dim - 1 && columns[i].mate != Column::none; ++m)
          active[columns[i].mate + m] = active[i];
      }
    }
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
  if constexpr (dim == 3)
    if (any_slides)
      return settle_damped(cell_size, negative_of_bodies);
  bool settled = false, repeats = false;
  std::set<std::vector<signed char>> seen{sides()};
  for (unsigned int pass = 0; pass < most_passes && !settled; ++pass)
  {
    ++passes;
    wants_inertia = (pass + 1) % passes_to_inertia == 0;
    if (!solve_active() ||
        (pass >= most_in_saddle && knows_inertia && wrong_inertia(negative_of_bodies) != 0))
      return false;
    const Eigen::VectorXd here = beyond();
    // Nothing holds the bodies: no set is right where they go so far.
    if (pass >= most_in_saddle && farthest_way(here) > farthest * cell_size)
      return false;
    const bool any_wrong = find_wrong(here, cell_size);
    if (any_wrong)
      change_sides(repeats ? share_of_worst : 0.);
    else
      settled = walls_stay(here);
    repeats = repeats || !seen.insert(sides()).second;
  }
  return settled && find_inertia();
}

template <int dim>
bool FrameSystem<dim>::settle_with_dents(const double cell_size, const unsigned int negative_of_bodies)
{
  if (softening.empty())
    return settle(cell_size, negative_of_bodies);
  const auto active_before = active;
  const auto slipping_before = slipping;
  const std::size_t n_own = own.size();
  own.insert(own.end(), softening.begin(), softening.end());
  const auto add_gaps = [this](const double factor)
  {
    for (const auto &[i, way] : softening_gap)
      right[i] += factor * way;
  };
  add_gaps(1.);
  if (settle(cell_size, negative_of_bodies))
    return true;
  own.resize(n_own);
  add_gaps(-1.);
  active = active_before;
  slipping = slipping_before;
  return settle(cell_size, negative_of_bodies);
}

template <int dim>
bool FrameSystem<dim>::solve(const double cell_size, const unsigned int negative_of_bodies, const bool begins)
{
  looks_at_start = begins;
  kept.clear();
  kept_off = 0.;
  right = -Eigen::Map<const Eigen::VectorXd>(gap.data(), gap.size());
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int i = 0; i < of_body[b].size(); ++i)
      right[of_body[b][i]] -= moved[b][i];
  by_threshold = false;
  bool settled = settle_with_dents(cell_size, negative_of_bodies);
  if (!settled && any_slides && find_inertia() && wrong_inertia(negative_of_bodies) == 0)
  {
    // Friction that is bounded by the forces of the last iterate instead of these is a minimum, whose sets
    // settle.
    by_threshold = true;
    looks_at_start = false;
    settled = settle(cell_size, negative_of_bodies);
  }
  found_ways.resize(ways.size());
  for (unsigned int w = 0; w < ways.size(); ++w)
    found_ways[w] = ways[w].at + z[w];
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
      found[columns[i].frame][columns[i].ray_number] = std::max(-columns[i].pull, z[i]);
    else if (columns[i].kind == Column::slide && columns[i].component == 0 && (active[i] || columns[i].keeps))
      note_friction(i);
  return settled;
}

template void FrameSystem<2>::number_unknowns();
template void FrameSystem<3>::number_unknowns();
template Eigen::VectorXd FrameSystem<2>::right_of_unknowns();
template Eigen::VectorXd FrameSystem<3>::right_of_unknowns();
template std::array<Eigen::VectorXd, 2> FrameSystem<2>::units_of_unknowns() const;
template std::array<Eigen::VectorXd, 2> FrameSystem<3>::units_of_unknowns() const;
template bool FrameSystem<2>::take_unknowns(const Eigen::VectorXd &);
template bool FrameSystem<3>::take_unknowns(const Eigen::VectorXd &);
template void FrameSystem<2>::add_effect(const Eigen::VectorXd &, Eigen::VectorXd &) const;
template void FrameSystem<3>::add_effect(const Eigen::VectorXd &, Eigen::VectorXd &) const;
template bool FrameSystem<3>::find_wrong(const Eigen::VectorXd &, double);
template double FrameSystem<3>::farthest_way(const Eigen::VectorXd &) const;
template bool FrameSystem<3>::walls_stay(const Eigen::VectorXd &);
template bool FrameSystem<2>::solve(double, unsigned int, bool);
template bool FrameSystem<3>::solve(double, unsigned int, bool);
} // namespace softgrain::mpm
