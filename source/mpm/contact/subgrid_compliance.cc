// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/plane_compliance.h>
#include <softgrain/mpm/contact/subgrid_compliance.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace softgrain::mpm
{
namespace
{
/// 1/R at rest.
double curvature(const Body<2> &body)
{
  return SubgridCompliance::is_round(body) ? std::sqrt(M_PI / body.rest.area) : 0.;
}

/// Measured widths, doc/results/rim.md: ln k = mean + by_angle cos 4θ + by_place cos⁴ 2θ cos 2πf.
struct Measured
{
  double poisson_ratio, mean, by_place;
};
constexpr Measured widths[] = {
    {0.00, -0.77, 0.23}, {0.30, -0.73, 0.23}, {0.40, -0.67, 0.20}, {0.45, -0.59, 0.18}, {0.49, -0.615, 0.15}};
constexpr double by_angle = 0.10;

/// Constants between the measured Poisson's ratios; beyond them those of the last.
Measured measured(const double poisson_ratio)
{
  const auto above = std::find_if(std::begin(widths), std::end(widths),
                                  [&](const Measured &at) { return at.poisson_ratio > poisson_ratio; });
  if (above == std::begin(widths))
    return widths[0];
  const Measured &below = *std::prev(above);
  if (above == std::end(widths))
    return below;
  const double share = (poisson_ratio - below.poisson_ratio) / (above->poisson_ratio - below.poisson_ratio);
  return {poisson_ratio, below.mean + share * (above->mean - below.mean),
          below.by_place + share * (above->by_place - below.by_place)};
}
} // namespace

double SubgridCompliance::log_full_width(const double poisson_ratio,
                                         const dealii::Point<2> &place,
                                         const dealii::Tensor<1, 2> &normal) const
{
  const Measured of_law = measured(poisson_ratio);
  // Along the outline, so along the line of the grid that is nearest to it in direction.
  const unsigned int along = std::abs(normal[1]) > std::abs(normal[0]) ? 0 : 1;
  const double fraction = (place[along] - lattice_lower[along]) / cell_size,
               cos_2 = normal[0] * normal[0] - normal[1] * normal[1], cos_2_squared = cos_2 * cos_2;
  return of_law.mean + by_angle * (2. * cos_2_squared - 1.) +
         of_law.by_place * cos_2_squared * cos_2_squared * std::cos(2. * M_PI * fraction);
}

SubgridCompliance::Dent SubgridCompliance::dent(const Body<2> &body,
                                                const Body<2> *partner,
                                                const std::array<double, 2> &log_full_width) const
{
  if (!on || (!is_round(body) && (partner == nullptr || !is_round(*partner))))
    return {};
  double curved = curvature(body), soft = plane_compliance(body), dents = is_round(body) ? soft : 0.,
         log_width = dents * log_full_width[0];
  if (partner != nullptr)
  {
    const double of_partner = is_round(*partner) ? plane_compliance(*partner) : 0.;
    curved += curvature(*partner);
    soft += plane_compliance(*partner);
    dents += of_partner;
    log_width += of_partner * log_full_width[1];
  }
  const double width = std::exp(log_width / dents) * cell_size;
  return {2. / M_PI * dents, 0.25 * M_PI * width * width * curved / soft};
}

namespace
{
/// Share of the full force below which a contact is linear. One that has just begun has no width yet; it is
/// kept from being infinitely soft. Before the first force is known the middle of the range stands for it.
constexpr double least_force = 2.6e-6, at_first = 0.65;
} // namespace

double SubgridCompliance::slope(const Dent &dent, const double force) const
{
  const double full = dent.full_force;
  if (dent.compliance == 0. || !(force < full))
    return 0.;
  const double change = force > least_force * full ? 0.5 * dent.compliance : 0.;
  return (*this)(dent, force) - change;
}

double SubgridCompliance::operator()(const Dent &dent, const double force) const
{
  if (dent.compliance == 0.)
    return 0.;
  const double share = force > 0.
                           ? 0.5 * std::log(dent.full_force / std::max(force, least_force * dent.full_force))
                           : at_first;
  return dent.compliance * std::max(0., share);
}

double SubgridCompliance::energy(const Dent &dent, const double force) const
{
  if (dent.compliance == 0. || !(force > 0.))
    return 0.;
  // δ = C F ln(F_full/F)/2 up to F_full, then none: F δ - ∫ δ dF. A contact that has grown wide has given
  // back what it took and more, for δ falls under larger forces; that stays with it.
  const double below = std::min(force, dent.full_force), half_log = 0.5 * std::log(dent.full_force / below);
  return 0.5 * dent.compliance * below * below * (half_log - 0.25);
}
} // namespace softgrain::mpm
