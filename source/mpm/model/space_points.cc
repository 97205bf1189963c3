// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/model/space_points.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int n_stress = dealii::SymmetricTensor<2, 3>::n_independent_components;
}

bool remembers(const Body<3> &body)
{
  return body.law->n_history() > 0;
}

std::vector<double> remembered_by_points(const std::vector<Body<3>> &bodies)
{
  std::vector<double> all;
  for (const Body<3> &body : bodies)
    for (unsigned int p = 0; p < body.points.size() && remembers(body); ++p)
    {
      const auto point = body.points[p];
      for (unsigned int i = 0; i < n_stress; ++i)
        all.push_back(point.stress().access_raw_entry(i));
      all.insert(all.end(), point.history(), point.history() + body.law->n_history());
    }
  return all;
}

void take_points(const std::vector<double> &remembered, std::vector<Body<3>> &bodies)
{
  const double *at = remembered.data();
  for (Body<3> &body : bodies)
    for (unsigned int p = 0; p < body.points.size() && remembers(body); ++p)
    {
      auto point = body.points[p];
      for (unsigned int i = 0; i < n_stress; ++i)
        point.stress().access_raw_entry(i) = *at++;
      std::copy_n(at, body.law->n_history(), point.history());
      at += body.law->n_history();
    }
}
} // namespace softgrain::mpm
