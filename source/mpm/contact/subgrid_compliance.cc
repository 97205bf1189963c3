// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/subgrid_compliance.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// (1-ν²)/E at rest; a driven body is rigid.
double plane_compliance(const Body<2> &body)
{
  if (body.driven)
    return 0.;
  const double nu = body.law->poisson_ratio();
  return (1. - nu * nu) / body.law->young_modulus();
}

bool is_round(const Body<2> &body)
{
  return body.boundary.circular && !body.driven;
}

/// 1/R at rest.
double curvature(const Body<2> &body)
{
  return is_round(body) ? std::sqrt(M_PI / body.rest_area) : 0.;
}
} // namespace

double SubgridCompliance::missing_share(const double half_width)
{
  // A contact that has just begun has no width yet; it is kept from being infinitely soft.
  return std::max(0., std::log(0.62 / std::max(half_width, 1e-3)));
}

double SubgridCompliance::operator()(const Body<2> &body, const Body<2> *partner, const double force) const
{
  if (!on || (!is_round(body) && (partner == nullptr || !is_round(*partner))))
    return 0.;
  double curved = curvature(body), soft = plane_compliance(body), dents = is_round(body) ? soft : 0.;
  if (partner != nullptr)
  {
    curved += curvature(*partner);
    soft += plane_compliance(*partner);
    dents += is_round(*partner) ? plane_compliance(*partner) : 0.;
  }
  const double half_width = std::sqrt(4. / M_PI * std::max(force, 0.) * soft / curved);
  // Before the first force is known the middle of the range stands for it.
  const double share = force > 0. ? missing_share(half_width / cell_size) : 0.65;
  return 2. / M_PI * dents * share;
}

double SubgridCompliance::energy(const Body<2> &body, const Body<2> *partner, const double force) const
{
  const double at_end = (*this)(body, partner, force);
  if (at_end == 0. || !(force > 0.))
    return 0.;
  // Work F δ(F) - ∫ δ dF, the integral by the midpoint rule; δ = C F is smooth but for two kinks.
  constexpr unsigned int n = 16;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double f = force * (i + 0.5) / n;
    sum += (*this)(body, partner, f) * f;
  }
  return at_end * force * force - sum * force / n;
}
} // namespace softgrain::mpm
