// SPDX-License-Identifier: LGPL-2.1-or-later
// How bodies of MpmModel move to other ranks between steps.
#include <softgrain/geometry/bisection.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// What becomes of lists when bodies move: each has the numbers of the bodies that lie here, one
/// body after the other.
class Journey
{
public:
  Journey(const BodyShare &share, const std::vector<unsigned int> &owners, const std::vector<char> &held)
      : share(share), owners(owners), held(held)
  {
  }

  bool moves(const unsigned int b) const { return owners[b] != share.owner(b); }
  bool comes(const unsigned int b) const { return moves(b) && owners[b] == share.exchange.here(); }

  /// The list with the bodies that will lie here, those that come as their owner has them. All call it.
  /// @param size of a body: how many numbers it has
  template <class Size>
  std::vector<double> take(const std::vector<double> &list, const Size &size) const
  {
    std::vector<std::vector<double>> leaving(share.exchange.number());
    std::vector<const double *> place(owners.size(), nullptr);
    const double *at = list.data();
    for (unsigned int b = 0; b < owners.size(); ++b)
      if (share.holds(b))
      {
        place[b] = at;
        at += size(b);
        if (moves(b) && share.mine(b))
          leaving[owners[b]].insert(leaving[owners[b]].end(), place[b], at);
      }
    const std::vector<std::vector<double>> coming = share.exchange.to_each(std::move(leaving));
    std::vector<const double *> next;
    for (const std::vector<double> &of_rank : coming)
      next.push_back(of_rank.data());
    std::vector<double> result;
    for (unsigned int b = 0; b < owners.size(); ++b)
      if (held[b])
      {
        const double *&from = comes(b) ? next[share.owner(b)] : place[b];
        result.insert(result.end(), from, from + size(b));
        from += size(b);
      }
    return result;
  }

private:
  const BodyShare &share; ///< as it was before
  const std::vector<unsigned int> &owners;
  const std::vector<char> &held;
};

/// What nodes of a body have, which all know and a grid that is laid starts anew.
struct NodalVectors
{
  explicit NodalVectors(const Body<2> &body)
      : displacement(body.nodes.displacement)
      , velocity(body.nodes.velocity)
      , velocity_of_points(body.nodes.velocity_of_points)
      , kept(body.nodes.kept)
      , internal_force(body.nodes.internal_force)
  {
  }
  void put(Body<2> &body) const
  {
    body.nodes.displacement = displacement;
    body.nodes.velocity = velocity;
    body.nodes.velocity_of_points = velocity_of_points;
    body.nodes.kept = kept;
    body.nodes.internal_force = internal_force;
  }
  Eigen::VectorXd displacement, velocity, velocity_of_points, kept, internal_force;
};
} // namespace

std::string MpmModel::share_out_anew()
{
  const BodyShare &share = work.share;
  if (!balance.uneven(share.exchange))
    return "";
  std::vector<dealii::Point<2>> centers;
  for (const Body<2> &body : state.bodies)
    centers.push_back(body.center());
  std::vector<double> costs = balance.measured(share);
  const unsigned int n_owners = share.exchange.number();
  std::vector<unsigned int> owners = bisect(centers, costs, n_owners);
  const double before = balance.imbalance(), expected = LoadBalance::imbalance_of(costs, owners, n_owners);
  if (!balance.pays(expected))
    return "";
  unsigned int n_moved = 0;
  for (const Body<2> &body : state.bodies)
    n_moved += !body.rigid.driven && owners[body.index] != share.owner(body.index);
  const RankTimes taken = share.exchange.taken();
  const double begin = processor_seconds();
  move_bodies(std::move(owners));
  double seconds = processor_seconds() - begin - (share.exchange.taken().spinning - taken.spinning);
  for (const std::vector<double> &of_rank : share.exchange.of_all({seconds}))
    seconds = std::max(seconds, of_rank[0]);
  balance.moved(std::move(costs), share.exchange, seconds);
  std::ostringstream text;
  text << std::setprecision(3) << "after step " << steps << " " << n_moved
       << " bodies have moved to other ranks, in " << seconds << " s: the busiest rank had " << before
       << " of the mean work, and is to have " << expected;
  return text.str();
}

void MpmModel::move_bodies(std::vector<unsigned int> owners)
{
  if (work.share.alone())
    return;
  const dealii::TimerOutput::Scope section(*timer, "bodies move");
  std::vector<char> held = held_here(owners);
  const Journey journey(work.share, owners, held);
  MemoryState points;
  save_points(points, false);
  const auto take = [&](const std::string &name, const unsigned int n_components)
  {
    points.write(name, journey.take(points.read_doubles(name, ListSize::rows_of(1)), [&](const unsigned int b)
                                    { return std::size_t(state.bodies[b].n_points) * n_components; }));
  };
  take("mpm/points/position", 2);
  for (const PointSlotDescription &slot : state.points->layout().slots())
    take("mpm/points/" + slot.name, slot.n_components);
  // What loads need to know of points at rest, in the same way.
  const auto rest_size = [&](const unsigned int b)
  { return state.bodies[b].loads.look_at_points() ? 2 * std::size_t(state.bodies[b].n_points) : 0; };
  std::vector<double> rest;
  for (const Body<2> &body : state.bodies)
    if (work.share.holds(body.index))
      for (const dealii::Point<2> &x : body.rest.position)
        rest.insert(rest.end(), x.begin_raw(), x.end_raw());
  rest = journey.take(rest, rest_size);
  std::vector<char> comes, goes;
  for (unsigned int b = 0; b < owners.size(); ++b)
  {
    comes.push_back(journey.comes(b));
    goes.push_back(journey.moves(b) && work.share.mine(b));
  }
  work.share.give(std::move(owners), std::move(held));
  const double *at = rest.data();
  for (Body<2> &body : state.bodies)
  {
    body.rest.position.clear();
    if (work.share.holds(body.index))
      for (const double *const end = at + rest_size(body.index); at < end; at += 2)
        body.rest.position.emplace_back(at[0], at[1]);
  }
  work.share.exchange.together([&]() { take_moved(points, comes, goes); });
}

void MpmModel::take_moved(const StateReader &points,
                          const std::vector<char> &comes,
                          const std::vector<char> &goes)
{
  if (problem.settings.grid_update == GridUpdate::never)
    cover_points(); // else it is all covered
  load_points(points, false);
  unsigned int first_id = 0;
  for (Body<2> &body : state.bodies)
  {
    body.points = {};
    if (!work.share.holds(body.index))
      continue;
    body.points =
        BodyPoints<2>(state.points->handler().get_property_pool(), state.points->layout(), first_id);
    first_id += body.n_points;
  }
  state.order_points();
  // The grids of those that stay are as they were.
  const BuildContext context{*problem.lattice, *problem.shape, problem.settings, *state.points};
  for (Body<2> &body : state.bodies)
  {
    const unsigned int b = body.index;
    if (!comes[b] && !goes[b])
      continue;
    const NodalVectors vectors(body);
    if (comes[b])
      lay_grid(body, context);
    else if (!work.share.holds(b))
      keep_outline(body);
    vectors.put(body);
    work.trial[b] = {};
    work.solvers[b].reset();
    work.matrices[b] = {};
    prepare_solver(body);
  }
}
} // namespace softgrain::mpm
