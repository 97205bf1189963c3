// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/hertz_compliance.h>
#include <softgrain/mpm/contact/plane_compliance.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// Measured, doc/results/three-dimensions.md: of the dent of a light contact the grid shows
/// F/(E* h) (shown - shown_by_ratio ν - shown_by_place (cos 2πf + cos 2πg)/2), with f and g the place in its
/// cell.
constexpr double shown = 1.285, shown_by_ratio = 0.4, shown_by_place = 0.235;

/// 1/R at rest.
double curvature(const Body<3> &body)
{
  return HertzCompliance::is_round(body) ? std::cbrt(4. / 3. * M_PI / body.rest.area) : 0.;
}
} // namespace

double HertzCompliance::log_full_width(const double poisson_ratio,
                                       const dealii::Point<3> &place,
                                       const dealii::Tensor<1, 3> &normal) const
{
  unsigned int across = 0; // of whose direction the surface is nearest to a plane of the grid
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(normal[d]) > std::abs(normal[across]))
      across = d;
  double waves = 0.;
  for (const unsigned int along : {(across + 1) % 3, (across + 2) % 3})
    waves += 0.5 * std::cos(2. * M_PI * (place[along] - lattice_lower[along]) / cell_size);
  // As in the plane the place no longer counts where the normal is between two directions of the grid.
  const double aligned = std::max(0., 2. * normal[across] * normal[across] - 1.);
  return std::log(0.75 /
                  (shown - shown_by_ratio * poisson_ratio - shown_by_place * std::pow(aligned, 4) * waves));
}

HertzDent HertzCompliance::dent(const Body<3> &body,
                                const Body<3> *partner,
                                const std::array<double, 2> &log_full_width) const
{
  if (!on || !is_round(body))
    return {};
  // Of each the grid shows beta F / (E* h).
  double soft = plane_compliance(body), curved = curvature(body),
         shown = plane_compliance(body) * 0.75 * std::exp(-log_full_width[0]);
  if (partner != nullptr)
  {
    soft += plane_compliance(*partner);
    curved += curvature(*partner);
    shown += plane_compliance(*partner) * 0.75 * std::exp(-log_full_width[1]);
  }
  return {1. / soft, 1. / curved, cell_size, shown / soft};
}
} // namespace softgrain::mpm
