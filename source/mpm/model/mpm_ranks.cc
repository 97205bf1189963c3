// SPDX-License-Identifier: LGPL-2.1-or-later
// How MpmModel shares its bodies out to ranks, and brings together what they know.
#include <softgrain/geometry/bisection.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Of the matrix of a body, as its cells ask for it.
unsigned int half_band(const BodyField<2> &field)
{
  unsigned int widest = 0;
  for (unsigned int c = 0; c < field.n_cells(); ++c)
  {
    const std::vector<unsigned int> &nodes = field.cell_independent(c);
    const auto [least, most] = std::minmax_element(nodes.begin(), nodes.end());
    if (least != nodes.end())
      widest = std::max(widest, 2 * (*most - *least) + 2);
  }
  return widest;
}

/// What a body costs: stiffness of its points, factors of its matrix.
double weight_of(const Body<2> &body)
{
  if (body.driven)
    return 0.;
  const double of_point = 2. * body.field.nodes_per_cell(), band = half_band(body.field);
  return of_point * of_point * body.points.size() + band * band * body.field.n_dofs();
}

constexpr unsigned int n_stress = dealii::SymmetricTensor<2, 2>::n_independent_components;

/// Of all points, one after the other.
std::vector<double> stress_and_history(const Body<2> &body)
{
  std::vector<double> numbers;
  const unsigned int n_history = body.law->n_history();
  numbers.reserve(body.points.size() * (n_stress + n_history));
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const auto point = body.points[p];
    for (unsigned int i = 0; i < n_stress; ++i)
      numbers.push_back(point.stress().access_raw_entry(i));
    if (n_history > 0)
      numbers.insert(numbers.end(), point.history(), point.history() + n_history);
  }
  return numbers;
}
} // namespace

void MpmModel::share_out_bodies()
{
  if (work.share.alone())
    return;
  std::vector<dealii::Point<2>> centers;
  std::vector<double> weights;
  for (const Body<2> &body : state.bodies)
  {
    centers.push_back(body.center());
    weights.push_back(weight_of(body));
  }
  work.share.give(bisect(centers, weights, work.share.ranks.number()));
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

void MpmModel::gather()
{
  if (work.share.alone())
    return;
  std::vector<std::vector<double>> of_bodies(state.bodies.size());
  work.share.share_lists(
      [&]()
      {
        work.share.for_mine_here(state.bodies, [&](const Body<2> &body)
                                 { of_bodies[body.index] = stress_and_history(body); });
      },
      of_bodies);
  for (Body<2> &body : state.bodies)
  {
    if (work.share.mine(body.index) || body.driven)
      continue;
    const double *number = of_bodies[body.index].data();
    for (unsigned int p = 0; p < body.points.size(); ++p)
    {
      auto point = body.points[p];
      for (unsigned int i = 0; i < n_stress; ++i)
        point.stress().access_raw_entry(i) = *number++;
      for (unsigned int i = 0; i < body.law->n_history(); ++i)
        point.history()[i] = *number++;
    }
  }
}
} // namespace softgrain::mpm
