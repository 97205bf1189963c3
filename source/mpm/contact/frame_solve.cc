// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of rays for given columns: which are closed, which stick and which slip.
#include <softgrain/mpm/contact/frame_system.h>

#include <unsupported/Eigen/IterativeSolvers>

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
constexpr double farthest = 5.;            ///< gap or slide of a step that may be [cells]
constexpr double usual_strain = 1. / 4096; ///< of a force over stiffness and way, where both count alike
constexpr unsigned int most_in_saddle = 3; ///< passes in which a set may belong to no minimum

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// A factor as Eigen's iterative solvers want their preconditioner, of a matrix whose rows and columns have
/// been given other units.
class ByFactor
{
public:
  ByFactor() = default;
  template <class M>
  ByFactor &analyzePattern(const M &)
  {
    return *this;
  }
  template <class M>
  ByFactor &factorize(const M &)
  {
    return *this;
  }
  template <class M>
  ByFactor &compute(const M &)
  {
    return *this;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd &b) const
  {
    return factor->solve(b.cwiseQuotient(*of_rows)).cwiseQuotient(*of_columns);
  }
  Eigen::ComputationInfo info() { return Eigen::Success; }

  const Factor *factor = nullptr;
  const Eigen::VectorXd *of_rows = nullptr, *of_columns = nullptr; ///< what the matrix was multiplied by
};
} // namespace

template <int dim>
bool FrameSystem<dim>::solve_active(const Eigen::VectorXd &right)
{
  std::vector<int> number(columns.size(), -1);
  int n = 0;
  for (const unsigned int i : order)
    if (counts(i))
      number[i] = n++;
  std::vector<Eigen::Triplet<double>> entries, by_slip;
  for (const auto &entry : own)
  {
    const int row = number[entry.row()], column = number[entry.col()];
    if (row >= 0 && column >= 0)
      entries.emplace_back(std::max(row, column), std::min(row, column), entry.value());
    // What slips gives to walls under loads.
    if (const unsigned int i = entry.row(); column >= 0 && active[i] && slips(i) != 0 && !by_threshold)
      by_slip.emplace_back(column, number[columns[i].mate], slips(i) * columns[i].bound * entry.value());
  }
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int j = 0; j < of_body[b].size(); ++j)
    {
      const unsigned int here = of_body[b][j];
      if (number[here] >= 0)
        for (unsigned int i = j; i < of_body[b].size(); ++i)
          if (const int row = number[of_body[b][i]]; row >= 0)
            entries.emplace_back(std::max(row, number[here]), std::min(row, number[here]), W[b](i, j));
      if (active[here] && slips(here) != 0 && !by_threshold)
        for (unsigned int i = 0; i < of_body[b].size(); ++i)
          if (const int row = number[of_body[b][i]]; row >= 0)
            by_slip.emplace_back(row, number[columns[here].mate],
                                 slips(here) * columns[here].bound * W[b](std::max(i, j), std::min(i, j)));
    }
  Matrix N(n, n);
  N.setFromTriplets(entries.begin(), entries.end());
  Factor factor(N);
  if (factor.info() != Eigen::Success)
    return false;
  n_free = 0;
  for (const FreeWay<dim> &way : ways)
    n_free += way.stopped == 0;
  negative = (factor.vectorD().array() < 0.).count();
  const Eigen::VectorXd known = set_known() ? Eigen::VectorXd(-beyond(right)) : right;
  Eigen::VectorXd b(n), x;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      b[number[i]] = known[i];
  if (by_slip.empty())
  {
    x = factor.solve(b);
    x += factor.solve(Eigen::VectorXd(b - N.selfadjointView<Eigen::Lower>() * x));
  }
  else
  {
    Matrix full = N.selfadjointView<Eigen::Lower>(), slipping_part(n, n);
    slipping_part.setFromTriplets(by_slip.begin(), by_slip.end());
    full += slipping_part;
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
    full = of_rows.asDiagonal() * full * of_columns.asDiagonal();
    Eigen::GMRES<Matrix, ByFactor> gmres;
    gmres.preconditioner().factor = &factor;
    gmres.preconditioner().of_rows = &of_rows;
    gmres.preconditioner().of_columns = &of_columns;
    gmres.compute(full);
    gmres.setTolerance(1e-12);
    gmres.set_restart(60);
    gmres.setMaxIterations(200);
    x = of_columns.cwiseProduct(gmres.solve(of_rows.cwiseProduct(b)));
    if (gmres.info() != Eigen::Success)
      return false;
  }
  if (!x.allFinite())
    return false;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      z[i] = x[number[i]];
  for (unsigned int i = 0; i < columns.size() && !by_threshold; ++i)
    if (active[i] && slips(i) != 0)
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
Eigen::VectorXd FrameSystem<dim>::beyond(const Eigen::VectorXd &right) const
{
  Eigen::VectorXd here = -right;
  for (unsigned int b = 0; b < of_body.size(); ++b)
    if (!of_body[b].empty())
    {
      const Eigen::VectorXd effect = W[b] * z_of(b);
      for (unsigned int i = 0; i < of_body[b].size(); ++i)
        here[of_body[b][i]] += effect[i];
    }
  for (const auto &entry : own)
  {
    here[entry.col()] += entry.value() * z[entry.row()];
    if (entry.row() != entry.col())
      here[entry.row()] += entry.value() * z[entry.col()];
  }
  return here;
}

template <int dim>
bool FrameSystem<dim>::change_sides(const Eigen::VectorXd &here, const double cell_size, const double share)
{
  double largest = 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray || columns[i].kind == Column::slide)
      largest = std::max(largest, std::abs(z[i]));
  wrong.setZero(columns.size()); // by how much a ray is where it must not be, as a force
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    const bool sticks = slips(i) == 0;
    const double as_force = here[i] * columns[i].stiffness;
    double amount = 0., allowed = 1e-10 * cell_size * columns[i].stiffness;
    if (columns[i].kind == Column::ray)
      amount = active[i] ? -(z[i] + columns[i].pull) : -as_force;
    else if (columns[i].kind == Column::slide && active[i])
      amount = sticks ? std::abs(z[i]) - most_friction(i) : slips(i) * as_force;
    if (active[i] && sticks)
      allowed = 1e-10 * largest;
    if (amount > allowed)
      wrong[i] = amount;
  }
  const double worst = wrong.size() > 0 ? wrong.maxCoeff() : 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (wrong[i] > 0. && wrong[i] >= share * worst)
    {
      signed char &slip = slipping[columns[i].frame][columns[i].ray_number];
      if (columns[i].kind == Column::slide)
        slip = slip != 0 ? 0 : z[i] > 0. ? 1 : -1;
      else
      {
        active[i] = !active[i];
        if (columns[i].mate != Column::none)
          active[columns[i].mate] = active[i];
      }
    }
  return worst == 0. && walls_stay(here);
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
bool FrameSystem<dim>::settle(const Eigen::VectorXd &right,
                              const double cell_size,
                              const unsigned int negative_of_bodies)
{
  bool settled = false, repeats = false;
  std::set<std::vector<signed char>> seen{sides()};
  for (unsigned int pass = 0; pass < most_passes && !settled; ++pass)
  {
    ++passes;
    if (!solve_active(right) || (pass >= most_in_saddle && wrong_inertia(negative_of_bodies) != 0))
      return false;
    const Eigen::VectorXd here = beyond(right);
    // Nothing holds the bodies: no set is right where they go so far.
    if (pass >= most_in_saddle && farthest_way(here) > farthest * cell_size)
      return false;
    settled = change_sides(here, cell_size, repeats ? share_of_worst : 0.);
    repeats = repeats || !seen.insert(sides()).second;
  }
  return settled;
}

template <int dim>
bool FrameSystem<dim>::solve(const double cell_size, const unsigned int negative_of_bodies)
{
  Eigen::VectorXd right = -Eigen::Map<const Eigen::VectorXd>(gap.data(), gap.size());
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int i = 0; i < of_body[b].size(); ++i)
      right[of_body[b][i]] -= moved[b][i];
  by_threshold = false;
  bool settled = settle(right, cell_size, negative_of_bodies);
  if (!settled && wrong_inertia(negative_of_bodies) == 0 && any_slides)
  {
    // Friction that is bounded by the forces of the last iterate instead of these is a minimum, whose sets
    // settle.
    by_threshold = true;
    settled = settle(right, cell_size, negative_of_bodies);
  }
  found_ways.resize(ways.size());
  for (unsigned int w = 0; w < ways.size(); ++w)
    found_ways[w] = ways[w].at + z[w];
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
      found[columns[i].frame][columns[i].ray_number] = std::max(-columns[i].pull, z[i]);
    else if (columns[i].kind == Column::slide && active[i])
      found_rubbing[columns[i].frame][columns[i].ray_number] = z[i];
  return settled;
}

template bool FrameSystem<2>::solve(double, unsigned int);
template bool FrameSystem<3>::solve(double, unsigned int);
} // namespace softgrain::mpm
