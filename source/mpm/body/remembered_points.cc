// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/remembered_points.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int n_stress = dealii::SymmetricTensor<2, 3>::n_independent_components;

void tell(const Body<3> &body, std::vector<double> &numbers)
{
  for (unsigned int p = 0; p < body.points.size() && remembers(body); ++p)
  {
    const auto point = body.points[p];
    for (unsigned int i = 0; i < n_stress; ++i)
      numbers.push_back(point.stress().access_raw_entry(i));
    numbers.insert(numbers.end(), point.history(), point.history() + body.material.law->n_history());
  }
}

const double *take(const double *at, Body<3> &body)
{
  for (unsigned int p = 0; p < body.points.size() && remembers(body); ++p)
  {
    auto point = body.points[p];
    for (unsigned int i = 0; i < n_stress; ++i)
      point.stress().access_raw_entry(i) = *at++;
    std::copy_n(at, body.material.law->n_history(), point.history());
    at += body.material.law->n_history();
  }
  return at;
}
} // namespace

bool remembers(const Body<3> &body)
{
  return body.material.law->n_history() > 0;
}

std::vector<double> remembered_by_points(const std::vector<Body<3>> &bodies)
{
  std::vector<double> all;
  for (const Body<3> &body : bodies)
    tell(body, all);
  return all;
}

void take_points(const std::vector<double> &remembered, std::vector<Body<3>> &bodies)
{
  const double *at = remembered.data();
  for (Body<3> &body : bodies)
    at = take(at, body);
}

void share_points(const BodyShare &share, std::vector<Body<3>> &bodies)
{
  if (share.alone() || std::none_of(bodies.begin(), bodies.end(), remembers))
    return;
  std::vector<std::vector<double>> told(bodies.size());
  share.share_lists(
      [&]() { share.for_mine_here(bodies, [&](const Body<3> &body) { tell(body, told[body.index]); }); },
      told);
  for (Body<3> &body : bodies)
    if (!share.mine(body.index))
      take(told[body.index].data(), body);
}
} // namespace softgrain::mpm
