// SPDX-License-Identifier: LGPL-2.1-or-later
// How MpmModel shares its bodies out to ranks, and what ranks tell each other of them.
#include <softgrain/geometry/bisection.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/body/told_grid.h>
#include <softgrain/mpm/model/body_cost.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/model/rank_report.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace softgrain::mpm
{
void MpmModel::share_out_bodies(const std::vector<BodyDescription<2>> &descriptions)
{
  if (work.share.alone())
    return;
  std::vector<dealii::Point<2>> centers;
  std::vector<double> weights;
  for (const BodyDescription<2> &body : descriptions)
  {
    const auto box = body.shape->bounding_box();
    centers.push_back(box.first + 0.5 * (box.second - box.first));
    weights.push_back(body.driven ? 0. : cost_of(group_of(body), problem.settings).iteration_seconds());
  }
  std::vector<unsigned int> owners = bisect(centers, weights, work.share.exchange.number());
  balance.start(std::move(weights));
  std::vector<char> held = held_here(owners);
  work.share.give(std::move(owners), std::move(held));
}

std::vector<char> MpmModel::held_here(const std::vector<unsigned int> &owners) const
{
  // Where bodies meet at their nodes, every rank looks at the points of all.
  std::vector<char> held;
  for (const Body<2> &body : state.bodies)
    held.push_back(owners[body.index] == work.share.exchange.here() || body.rigid.driven ||
                   !problem.settings.meets_by_rays());
  return held;
}

void MpmModel::keep_outline(Body<2> &body)
{
  take_grid(tell_grid(body), *problem.lattice, *problem.shape, body);
}

std::vector<unsigned int> MpmModel::all_bodies() const
{
  std::vector<unsigned int> all(state.bodies.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

void MpmModel::share_grids(const std::vector<unsigned int> &of_bodies)
{
  if (work.share.alone() || !problem.settings.meets_by_rays())
    return;
  // Not all at once: what is sent takes memory on every rank.
  const std::size_t at_once = std::max<std::size_t>(16, of_bodies.size() / 64);
  for (std::size_t first = 0; first < of_bodies.size(); first += at_once)
  {
    const auto begin = of_bodies.begin() + first,
               end = of_bodies.begin() + std::min(first + at_once, of_bodies.size());
    std::vector<std::vector<double>> told(state.bodies.size());
    work.share.share_lists(
        [&]()
        {
          for (auto b = begin; b != end; ++b)
            if (work.share.mine(*b) && !state.bodies[*b].rigid.driven)
              told[*b] = tell_grid(state.bodies[*b]);
        },
        told);
    for (auto b = begin; b != end; ++b)
      if (!work.share.holds(*b))
        take_grid(told[*b], *problem.lattice, *problem.shape, state.bodies[*b]);
  }
}

/// Where all ranks have all points, they move those of all bodies to their new grids, and volumes of small
/// strain belong to that.
void MpmModel::share_trial_volumes(const std::vector<unsigned int> &of_bodies)
{
  if (problem.settings.meets_by_rays())
    return;
  BodyShare::Message message(work.share);
  for (const unsigned int b : of_bodies)
    if (const Body<2> &body = state.bodies[b]; body.material.small_strain() && !body.rigid.driven)
    {
      work.trial[b].volume.resize(body.points.size());
      message.add(b, work.trial[b].volume.data(), body.points.size());
    }
  message.send();
}

void MpmModel::add_ranks(SizeReport &report) const
{
  if (work.share.alone())
    return;
  const std::vector<unsigned int> bodies = report_bodies_of_ranks(work.share, state.bodies, report);
  double fewest_points = state.points->size(), most_points = fewest_points;
  for (const std::vector<double> &of_rank : work.share.exchange.of_all({most_points}))
  {
    fewest_points = std::min(fewest_points, of_rank[0]);
    most_points = std::max(most_points, of_rank[0]);
  }
  report.emplace_back("points of a rank", std::to_string(static_cast<std::size_t>(fewest_points)) + " to " +
                                              std::to_string(static_cast<std::size_t>(most_points)));
  report_idle_ranks(bodies, report);
}
} // namespace softgrain::mpm
