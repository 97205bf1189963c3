// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/moved_boundary.h>
#include <softgrain/mpm/stepping/following_rows.h>
#include <softgrain/mpm/stepping/step_rows.h>

#include <algorithm>
#include <array>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// Move of bodies [cells] that changes rows: without inertia light contacts are to be in balance, and a pull
/// may reach no further than a small share of a cell.
constexpr double row_tolerance = 2e-5, row_tolerance_moving = 1e-3;
/// Way of bodies over a step [cells] up to which gaps are linear in it: as far as a body is not smaller than
/// a cell, to u²/8R < 0.005 cells.
constexpr double short_way = 0.2;
constexpr double small_lag =
    0.1; ///< share of the way of a step by which rows may lag behind and still follow
/// Up to which move of nodes [cells] searches are mixed.
constexpr double mixing_range = 0.15;
/// Growth of that move since the search before at which mixing begins anew. In full packings, and where a
/// corner lies in a dent that it has pressed, moves grow by 2 to 5: what mixing knows of them must not be
/// forgotten just then. Where bodies are not nearly in balance it knows little.
constexpr double mixing_growth = 5., mixing_growth_off_balance = 2., off_balance = 0.1;
/// Share of the way back to the last outcome below which it is not worth an evaluation of the stress.
constexpr double least_share = 0.05;
} // namespace

FollowingRows::FollowingRows(const Problem &problem,
                             const State &state,
                             Workspace &work,
                             const double dt,
                             const std::vector<WallMotion<2>> &motion)
    : problem(problem), state(state), work(work), dt(dt), motion(motion)
{
}

void FollowingRows::find(const Vectors &increment, const bool again)
{
  n_searches += again;
  const bool follow = problem.settings.rows_follow() && problem.settings.scheme.inertia;
  if (!again && follow)
    start_gaps = true_gaps(problem, state, work, motion, dt, increment, 0.);
  place = increment;
  find_rows(problem, state, work, motion, dt, &place, problem.settings.scheme.row_share, again,
            follow ? &start_gaps.here : nullptr);
}

double FollowingRows::way(const Vectors &increment, const Vectors *from) const
{
  const auto ways =
      work.share.numbers<1>(state.bodies,
                            [&](const Body<2> &body)
                            {
                              const Eigen::VectorXd &u = increment[body.index];
                              return std::array<double, 1>{largest_way(
                                  body, from == nullptr ? u : Eigen::VectorXd(u - (*from)[body.index]))};
                            });
  double way = 0.;
  for (const auto &of_body : ways)
    way = std::max(way, of_body[0]);
  return way;
}

double FollowingRows::lag(const Vectors &increment) const
{
  return problem.settings.rows_follow() ? way(increment, &place) : 0.;
}

bool FollowingRows::settled(const double lag) const
{
  const bool coarsely = problem.settings.scheme.inertia && !problem.pairs.adhere();
  return lag <= (coarsely ? row_tolerance_moving : row_tolerance) * problem.lattice->cell_size();
}

bool FollowingRows::follow(const Vectors &increment) const
{
  return way(increment, &place) <= small_lag * way(increment, nullptr);
}

bool FollowingRows::mix(Vectors &increment, const double lag, const double residual)
{
  BodyShare::Message message(work.share);
  for (Vectors *const vectors : {&place, &increment})
    message.add(state.bodies, *vectors);
  message.send();
  const double range = mixing_range * problem.lattice->cell_size();
  if (lag > range || lag > (residual > off_balance ? mixing_growth_off_balance : mixing_growth) * last_lag)
    mixing.restart();
  last_lag = lag;
  if (lag > range)
    return go_between(increment);
  last_outcome.clear();
  increment = mixing.next(place, increment);
  return true;
}

// Far from the solution mixing misleads where it goes beyond what it knows: round bodies slip past each
// other. Between the last two outcomes it is safe, and rows that swing come to rest there.
bool FollowingRows::go_between(Vectors &increment)
{
  double along = 0., square = 0.;
  for (unsigned int b = 0; b < last_outcome.size(); ++b)
  {
    const Eigen::VectorXd change = increment[b] - place[b], differs = change - last_change[b];
    along += differs.dot(change);
    square += differs.squaredNorm();
  }
  const double share = square > 0. ? std::min(1., along / square) : 0.;
  const Vectors before = std::exchange(last_outcome, increment);
  last_change.resize(increment.size());
  for (unsigned int b = 0; b < increment.size(); ++b)
    last_change[b] = increment[b] - place[b];
  if (share < least_share)
    return false;
  for (unsigned int b = 0; b < increment.size(); ++b)
    increment[b] -= share * (increment[b] - before[b]);
  return true;
}

double FollowingRows::penetration_at_start() const
{
  return start_gaps.deepest;
}

double FollowingRows::penetration(const Vectors &increment) const
{
  if (work.contact.empty())
    return 0.;
  if (problem.settings.rows_follow() && problem.settings.scheme.inertia &&
      way(increment, nullptr) > short_way * problem.lattice->cell_size())
    return true_gaps(problem, state, work, motion, dt, increment, 1.).deepest;
  double worst = 0.;
  const std::vector<double> gaps = end_gaps(state, work, increment, motion, dt),
                            dents = work.contact.subgrid_overlap(dt);
  for (unsigned int r = 0; r < gaps.size(); ++r)
    worst = std::max(worst, -gaps[r] - dents[r]);
  return worst;
}
} // namespace softgrain::mpm
