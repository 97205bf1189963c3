// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/random_sizes.h>

#include <deal.II/base/numbers.h>

namespace softgrain::bpm
{
double random_diameter(const PrimarySettings &settings, Uniform &random)
{
  const double u = random(), low = settings.smallest_diameter, high = settings.largest_diameter;
  if (settings.distribution == SizeDistribution::uniform_by_number)
    return low + u * (high - low);
  // The inverse of the distribution function of p(d) = (d^-2) / (1/low - 1/high).
  return 1. / (1. / low - u * (1. / low - 1. / high));
}

std::vector<double> random_radii(const PrimarySettings &settings, const double area, Uniform &random)
{
  std::vector<double> radii;
  double filled = 0.;
  for (;;)
  {
    const double r = 0.5 * random_diameter(settings, random);
    const double own = dealii::numbers::PI * r * r;
    if (settings.number > 0 ? radii.size() == settings.number : filled + 0.5 * own > area)
      return radii;
    radii.push_back(r);
    filled += own;
  }
}
} // namespace softgrain::bpm
