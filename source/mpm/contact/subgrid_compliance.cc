// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/subgrid_compliance.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// Half width, in cells, from which on the grid misses nothing.
constexpr double full_width = 0.62;

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
  return std::max(0., std::log(full_width / std::max(half_width, 1e-3)));
}

SubgridCompliance::Dent SubgridCompliance::dent(const Body<2> &body, const Body<2> *partner) const
{
  if (!on || (!is_round(body) && (partner == nullptr || !is_round(*partner))))
    return {};
  double curved = curvature(body), soft = plane_compliance(body), dents = is_round(body) ? soft : 0.;
  if (partner != nullptr)
  {
    curved += curvature(*partner);
    soft += plane_compliance(*partner);
    dents += is_round(*partner) ? plane_compliance(*partner) : 0.;
  }
  const double width = full_width * cell_size;
  return {2. / M_PI * dents, 0.25 * M_PI * width * width * curved / soft};
}

double SubgridCompliance::operator()(const Body<2> &body, const Body<2> *partner, const double force) const
{
  const Dent missed = dent(body, partner);
  if (missed.compliance == 0.)
    return 0.;
  // Before the first force is known the middle of the range stands for it.
  const double share = force > 0. ? missing_share(full_width * std::sqrt(force / missed.full_force)) : 0.65;
  return missed.compliance * share;
}

double SubgridCompliance::energy(const Body<2> &body, const Body<2> *partner, const double force) const
{
  const Dent missed = dent(body, partner);
  if (missed.compliance == 0. || !(force > 0.))
    return 0.;
  // δ = C F ln(F_full/F)/2 up to F_full, then none: F δ - ∫ δ dF. A contact that has grown wide has given
  // back what it took and more, for δ falls under larger forces; that stays with it.
  const double below = std::min(force, missed.full_force),
               half_log = 0.5 * std::log(missed.full_force / below);
  return 0.5 * missed.compliance * below * below * (half_log - 0.25);
}
} // namespace softgrain::mpm
