// SPDX-License-Identifier: LGPL-2.1-or-later
// How MpmModel shares its bodies out to ranks, and what ranks tell each other of them.
#include <softgrain/geometry/bisection.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/mpm/model/body_cost.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>
#include <numeric>

namespace softgrain::mpm
{
namespace
{
/// What ranks without the points of a body know of its grid, number by number. @param everywhere also how its
/// nodes move its outline
std::vector<double> outline_of_grid(const Body<2> &body, const bool everywhere)
{
  const BodyField<2> &field = body.field;
  std::vector<double> numbers = {
      static_cast<double>(body.n_points), body.rest_area, static_cast<double>(field.n_independent()),
      static_cast<double>(body.velocity.size()), static_cast<double>(body.acceleration.size())};
  for (unsigned int i = 0; i < field.n_independent(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      numbers.push_back(field.position(field.node_of_independent(i))[d]);
  for (const Eigen::VectorXd *const vector : {&body.mass, &body.velocity, &body.acceleration})
    numbers.insert(numbers.end(), vector->data(), vector->data() + vector->size());
  for (std::size_t m = 0; everywhere && m < field.all_marker_weights().size(); ++m)
  {
    const NodeWeightsView weights = field.marker_weights(m);
    numbers.push_back(weights.size);
    numbers.insert(numbers.end(), weights.node, weights.node + weights.size);
    numbers.insert(numbers.end(), weights.weight, weights.weight + weights.size);
  }
  return numbers;
}

/// Reads numbers one after the other.
class Reader
{
public:
  explicit Reader(const std::vector<double> &numbers) : at(numbers.data()) {}

  double number() { return *at++; }
  std::size_t count() { return static_cast<std::size_t>(*at++); }
  void take(Eigen::VectorXd &vector, const std::size_t size)
  {
    vector = Eigen::Map<const Eigen::VectorXd>(at, size);
    at += size;
  }
  void add_weights(WeightsOfPlaces &places)
  {
    const std::size_t n = count();
    places.add(at, at + n, n);
    at += 2 * n;
  }

private:
  const double *at;
};

/// Gives @p body what outline_of_grid() has told, as lay_grid() would have done.
void take_outline_of_grid(const std::vector<double> &numbers, const bool everywhere, Body<2> &body)
{
  Reader in(numbers);
  body.n_points = in.count();
  body.rest_area = in.number();
  const std::size_t n_nodes = in.count(), n_velocity = in.count(), n_acceleration = in.count();
  std::vector<dealii::Point<2>> nodes(n_nodes);
  for (dealii::Point<2> &x : nodes)
    for (unsigned int d = 0; d < 2; ++d)
      x[d] = in.number();
  in.take(body.mass, n_nodes);
  in.take(body.velocity, n_velocity);
  in.take(body.acceleration, n_acceleration);
  WeightsOfPlaces markers;
  for (std::size_t m = 0; everywhere && m < body.boundary.position.size(); ++m)
    in.add_weights(markers);
  markers.finish();
  body.field.take_outline(std::move(nodes), std::move(markers));
  body.displacement = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.velocity_of_points = body.velocity;
  body.internal_force = body.displacement;
}
} // namespace

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
  std::vector<unsigned int> owners = bisect(centers, weights, work.share.ranks.number());
  balance.start(std::move(weights));
  std::vector<char> held = held_here(owners);
  work.share.give(std::move(owners), std::move(held));
}

std::vector<char> MpmModel::held_here(const std::vector<unsigned int> &owners) const
{
  // Where bodies meet at their nodes, every rank looks at the points of all.
  std::vector<char> held;
  for (const Body<2> &body : state.bodies)
    held.push_back(owners[body.index] == work.share.ranks.here() || body.driven ||
                   !problem.settings.contact_on_boundaries);
  return held;
}

void MpmModel::keep_outline(Body<2> &body)
{
  const bool everywhere = problem.outlines_everywhere();
  take_outline_of_grid(outline_of_grid(body, everywhere), everywhere, body);
}

std::vector<unsigned int> MpmModel::all_bodies() const
{
  std::vector<unsigned int> all(state.bodies.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

void MpmModel::share_grids(const std::vector<unsigned int> &of_bodies)
{
  if (work.share.alone() || !problem.settings.contact_on_boundaries)
    return;
  const bool everywhere = problem.outlines_everywhere();
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
            if (work.share.mine(*b) && !state.bodies[*b].driven)
              told[*b] = outline_of_grid(state.bodies[*b], everywhere);
        },
        told);
    for (auto b = begin; b != end; ++b)
      if (!work.share.holds(*b))
        take_outline_of_grid(told[*b], everywhere, state.bodies[*b]);
  }
}

/// Where all ranks have all points, they move those of all bodies to their new grids, and volumes of small
/// strain belong to that.
void MpmModel::share_trial_volumes(const std::vector<unsigned int> &of_bodies)
{
  if (problem.settings.contact_on_boundaries)
    return;
  BodyShare::Message message(work.share);
  for (const unsigned int b : of_bodies)
    if (const Body<2> &body = state.bodies[b]; body.small_strain() && !body.driven)
    {
      work.trial[b].volume.resize(body.points.size());
      message.add(b, work.trial[b].volume.data(), body.points.size());
    }
  message.send();
}

void MpmModel::check_ranks_agree(const StepReport &report) const
{
  if (work.share.alone())
    return;
  double moved = 0.;
  for (const Body<2> &body : state.bodies)
    moved += body.displacement.squaredNorm();
  work.share.ranks.check_alike({report.dt, report.newton_residual, report.contact_residual, moved});
}
} // namespace softgrain::mpm
