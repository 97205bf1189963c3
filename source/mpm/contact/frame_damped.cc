// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of rays with friction in space: Newton's method for what is off, damped.
#include <softgrain/mpm/contact/frame_system.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// The first sets follow from gaps alone: their solutions are taken whole.
constexpr unsigned int undamped_passes = 4;
/// Passes in which a set may belong to no minimum: on the way most do.
constexpr unsigned int most_in_saddle = 7;
constexpr unsigned int most_halvings = 5;
constexpr double share_less = 0.2; ///< of the square that is off, which a whole way takes away at least
constexpr unsigned int passes_to_halve = 3; ///< what is off, until sets are taken to change for ever
/// What is off by less is off at a few rays that find no side: they keep their friction.
constexpr double few_are_off = 1e-2;
/// Passes after which directions are right, too. Elsewhere the next iteration of a step makes them right, but
/// with rays that keep their friction each begins alike.
constexpr unsigned int passes_to_turn = 2;
constexpr double nearly_solved = 1e-6; ///< share of the largest force
} // namespace

template <int dim>
typename FrameSystem<dim>::Trial FrameSystem<dim>::trial_of(const unsigned int i, const Iterate &at) const
{
  const double stiffness = columns[i].stiffness;
  Trial trial{std::max(0., at.z[i] + columns[i].pull - stiffness * at.here[i]), 0., 0., 0., 0.};
  const unsigned int slide = columns[i].mate;
  if (slide == Column::none || trial.force == 0.)
    return trial;
  trial.most = by_threshold ? columns[slide].threshold : columns[slide].bound * trial.force;
  trial.along = at.z[slide] - stiffness * at.here[slide];
  trial.across = at.z[slide + 1] - stiffness * at.here[slide + 1];
  trial.length = std::hypot(trial.along, trial.across);
  return trial;
}

template <int dim>
double FrameSystem<dim>::square_off(const Iterate &at) const
{
  const auto square = [](const double x) { return x * x; };
  double sum = 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
    {
      const Trial trial = trial_of(i, at);
      sum += square(at.z[i] + columns[i].pull - trial.force);
      const unsigned int slide = columns[i].mate;
      if (slide == Column::none || columns[slide].keeps)
        continue;
      const double share = trial.length > trial.most ? trial.most / trial.length : 1.;
      sum += square(at.z[slide] - share * trial.along) + square(at.z[slide + 1] - share * trial.across);
    }
  return sum;
}

template <int dim>
void FrameSystem<dim>::take_sides()
{
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
    {
      const Trial trial = trial_of(i, from);
      active[i] = trial.force > 0.;
      const unsigned int slide = columns[i].mate;
      if (slide == Column::none)
        continue;
      active[slide] = active[slide + 1] = active[i];
      if (!active[i] || columns[slide].keeps)
        continue;
      signed char &slip = slipping[columns[i].frame][columns[i].ray_number];
      slip = trial.length > trial.most;
      if (slip == 0)
        continue;
      turn_slides(slide, trial.along / trial.length, trial.across / trial.length);
      columns[slide + 1].give =
          (trial.length - trial.most) / (std::max(trial.most, 1e-12 * trial.length) * columns[i].stiffness);
    }
}

template <int dim>
typename FrameSystem<dim>::Iterate FrameSystem<dim>::iterate_of(Eigen::VectorXd here) const
{
  for (unsigned int i = 0; i < columns.size(); ++i)
    here[i] -= give_of(i) * z[i];
  return {z, std::move(here)};
}

template <int dim>
typename FrameSystem<dim>::Iterate FrameSystem<dim>::iterate_at_hand()
{
  z = at_hand;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::slide && columns[i].component == 0)
    {
      const Across friction = at_hand[i] * columns[i].axis_of_v + at_hand[i + 1] * columns[i + 1].axis_of_v;
      z[i] = friction * columns[i].axis;
      z[i + 1] = friction * columns[i + 1].axis;
    }
  return iterate_of(beyond());
}

template <int dim>
double FrameSystem<dim>::go_damped(const Iterate &to, const double before, const bool all_the_way)
{
  const Iterate start = from;
  double least = std::numeric_limits<double>::infinity(), share = 1.;
  Iterate at;
  for (unsigned int n_halved = 0; n_halved <= most_halvings; ++n_halved, share *= 0.5)
  {
    at.z = start.z + share * (to.z - start.z);
    at.here = start.here + share * (to.here - start.here);
    if (const double off = square_off(at); off < least)
    {
      least = off;
      from = at;
    }
    if (all_the_way || least < (1. - share_less * share) * before)
      break;
  }
  return least;
}

template <int dim>
double FrameSystem<dim>::unsolved(const Eigen::VectorXd &here) const
{
  double most = 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0 && (columns[i].kind == Column::ray || columns[i].kind == Column::slide))
      most = std::max(most, columns[i].stiffness * std::abs(here[i]));
  return most;
}

template <int dim>
double FrameSystem<dim>::forces_squared(const Eigen::VectorXd &of_columns) const
{
  double sum = 0.;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray || columns[i].kind == Column::slide)
      sum += of_columns[i] * of_columns[i];
  return sum;
}

template <int dim>
bool FrameSystem<dim>::solve_pass(const double cell_size, Eigen::VectorXd &here, bool &any_wrong)
{
  number_unknowns();
  if (!factorize_active() || !solve_with_factors(false))
    return false;
  here = beyond();
  any_wrong = find_wrong(here, cell_size);
  if (any_wrong && unsolved(here) < nearly_solved * largest)
    return true;
  if (!solve_with_factors(true))
    return false;
  here = beyond();
  any_wrong = find_wrong(here, cell_size);
  return true;
}

template <int dim>
void FrameSystem<dim>::begin_damped()
{
  for (Column &column : columns)
    column.keeps = false;
  kept.clear();
  kept_off = 0.;
  from = iterate_at_hand();
  nearest = from.z;
}

template <int dim>
void FrameSystem<dim>::keep_friction(const double off)
{
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    const unsigned int slide = columns[i].kind == Column::slide ? i : columns[i].mate;
    if (wrong[i] == 0. || slide == Column::none || columns[slide].keeps)
      continue;
    const unsigned int ray = columns[slide].mate;
    const double friction = std::hypot(nearest[slide], nearest[slide + 1]),
                 most = columns[slide].bound * std::max(0., nearest[ray] + columns[ray].pull);
    for (unsigned int m = 0; m < 2; ++m)
    {
      columns[slide + m].keeps = true;
      columns[slide + m].kept = nearest[slide + m] * (friction > most ? most / friction : 1.);
    }
    slipping[columns[i].frame][columns[i].ray_number] = 0;
    kept.emplace_back(columns[i].frame, columns[i].ray_number);
    kept_off = std::max(kept_off, off);
  }
}

/// Forces that are off where their conditions bend: P = max(0, P - k g), and friction T is the one nearest to
/// T - k s that the force allows. A solution for given sides is a step of Newton's method for these
/// equations, and what is off along the way to it follows without further products with W. A whole step may
/// make worse what it is to end.
///
/// Rays are about as dense as the shapes of a field. So friction that goes with the force of one ray may lift
/// the surface there more than the force presses it down, and the ray is right neither open nor closed; or it
/// neither sticks nor slips. When a few such rays are left, they keep the friction of the forces that were
/// least off, and the next iteration of the step begins with it.
template <int dim>
bool FrameSystem<dim>::settle_damped(const double cell_size, const unsigned int negative_of_bodies)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  begin_damped();
  double off = square_off(from), least_share = infinite;
  unsigned int halved_at = 0, n_right = 0;
  Eigen::VectorXd here;
  for (unsigned int pass = 0; pass < most_passes; ++pass)
  {
    ++passes;
    const bool looks = pass == 0 && looks_at_start;
    wants_inertia = looks || (pass + 1) % passes_to_inertia == 0;
    bool any_wrong = false;
    if (!solve_pass(cell_size, here, any_wrong))
      return false;
    if (looks)
      began_in_minimum = began_in_minimum || wrong_inertia(negative_of_bodies) == 0;
    if (pass >= most_in_saddle && ((knows_inertia && wrong_inertia(negative_of_bodies) != 0) ||
                                   farthest_way(here) > farthest * cell_size))
      return false;
    n_right = any_wrong ? 0 : n_right + 1;
    if (!any_wrong && walls_stay(here) && (kept.empty() || n_right > passes_to_turn))
      return find_inertia();
    off = go_damped(iterate_of(here), off, !any_wrong || pass < undamped_passes);
    const double share = std::sqrt(off / forces_squared(from.z));
    if (!any_wrong)
      least_share = infinite; // A wall has come to its stop or left it.
    if (any_wrong && share < least_share)
    {
      if (share < 0.5 * least_share)
        halved_at = pass;
      least_share = share;
      nearest = from.z;
    }
    if (any_wrong && pass >= halved_at + passes_to_halve && least_share < few_are_off)
    {
      keep_friction(least_share);
      off = square_off(from);
      halved_at = pass;
    }
    take_sides();
  }
  return false;
}

template bool FrameSystem<3>::settle_damped(double, unsigned int);
} // namespace softgrain::mpm
