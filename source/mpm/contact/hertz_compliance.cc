// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/hertz_compliance.h>

#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// (1-ν²)/E at rest; a driven body is rigid.
double compliance(const Body<3> &body)
{
  if (body.driven)
    return 0.;
  const double nu = body.law->poisson_ratio();
  return (1. - nu * nu) / body.law->young_modulus();
}

/// 1/R at rest.
double curvature(const Body<3> &body)
{
  return HertzCompliance::is_round(body) ? std::cbrt(4. / 3. * M_PI / body.rest_area) : 0.;
}
} // namespace

double HertzCompliance::log_full_width(const double /*poisson_ratio*/,
                                       const dealii::Point<3> & /*place*/,
                                       const dealii::Tensor<1, 3> & /*normal*/) const
{
  return std::log(0.75 / 1.1);
}

HertzDent HertzCompliance::dent(const Body<3> &body,
                                const Body<3> *partner,
                                const std::array<double, 2> &log_full_width) const
{
  if (!on || !is_round(body))
    return {};
  // Of each the grid shows beta F / (E* h).
  double soft = compliance(body), curved = curvature(body),
         shown = compliance(body) * 0.75 * std::exp(-log_full_width[0]);
  if (partner != nullptr)
  {
    soft += compliance(*partner);
    curved += curvature(*partner);
    shown += compliance(*partner) * 0.75 * std::exp(-log_full_width[1]);
  }
  return {1. / soft, 1. / curved, cell_size, shown / soft};
}
} // namespace softgrain::mpm
