// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>
#include <softgrain/packing/shrinking_box.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace softgrain
{
namespace
{
/// Share of area that disks thrown at random reach at once.
constexpr double loose_fraction = 0.40;
/// Share that the length of the box loses in a step, and steps at rest, where it counts as jammed: when that
/// is not wanted, and when it is.
struct Jamming
{
  double shrinkage;
  unsigned int rests;
};
constexpr Jamming avoided = {2e-5, 200}, wanted = {1e-4, 30};
/// Share of the mean radius that disks may overlap; it is taken from the radii at the end.
constexpr double allowed_overlap = 1e-3;

double mean_of(const std::vector<double> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / values.size();
}

/// Area of disks that have lost @p taken of their radii [m^2].
double area_of(const std::vector<double> &radii, const double taken = 0.)
{
  double area = 0.;
  for (const double r : radii)
    area += dealii::numbers::PI * (r - taken) * (r - taken);
  return area;
}

/// Makes the box smaller until @p end [m, half of its first edge], or until the disks jam. @return whether
/// they did.
bool shrink(ShrinkingBox &box, const double end, const double mean, const PackingProtocol &protocol)
{
  const Jamming jamming = protocol.jam ? wanted : avoided;
  const double allowed = allowed_overlap * mean;
  double shrinkage = ShrinkingBox::largest_shrinkage;
  while (box.scale() > end * (1. + 1e-12))
  {
    const std::vector<ShrinkingBox::Place> before = box.disks();
    const double scale = box.scale();
    double overlap = box.step(std::max(end / scale, 1. - shrinkage));
    for (unsigned int rest = 0; overlap > allowed && overlap < 0.5 * mean && rest < jamming.rests; ++rest)
      overlap = box.step(1.);
    if (overlap > allowed)
    {
      // Near jamming disks must go long ways for little: a smaller step leaves them time to.
      box.restore(before, scale);
      shrinkage *= 0.3;
      if (!protocol.patient || shrinkage < jamming.shrinkage)
        return true;
      continue;
    }
    shrinkage = std::min(ShrinkingBox::largest_shrinkage, 1.2 * shrinkage);
  }
  return false;
}
} // namespace

double Packing::solid_area() const
{
  double area = 0.;
  for (const Disk &disk : disks)
    area += dealii::numbers::PI * disk.radius * disk.radius;
  return area;
}

Packing pack_disks(const std::vector<double> &radius,
                   const dealii::Point<2> &lower,
                   const dealii::Point<2> &upper,
                   Uniform &random,
                   const PackingProtocol &protocol)
{
  const dealii::Tensor<1, 2> edges = upper - lower;
  const double fraction = area_of(radius) / (edges[0] * edges[1]);
  std::ostringstream numbers;
  numbers << radius.size() << " disks fill " << fraction << " of the box";
  if (fraction > 0.9 && !protocol.jam)
    throw InputError("'Packing': " + numbers.str() + "; at most about 0.80 is possible");
  for (unsigned int d = 0; d < 2; ++d)
    if (protocol.periodic[d] && !protocol.jam &&
        edges[d] < 6. * *std::max_element(radius.begin(), radius.end()))
      throw InputError("'Packing': a periodic box must be wider than three of its largest disks");
  const double growth = protocol.jam ? std::sqrt(fraction / loose_fraction)
                                     : std::max(1., std::sqrt(fraction / loose_fraction));
  const ShrinkingBox::Form form{
      {0.5 * growth * edges[0], 0.5 * growth * edges[1]}, protocol.periodic, protocol.friction};
  ShrinkingBox box(radius, form, random);
  const double mean = mean_of(radius);
  const bool tight = protocol.jam || growth > 1.;
  const bool jammed = tight && shrink(box, protocol.jam ? 0. : 0.5 * edges[0], mean, protocol);
  if (jammed && !protocol.jam)
    throw InputError("'Packing': the disks jam before they are in the box: " + numbers.str() +
                     "; enlarge the box or use fewer disks");

  // Jammed disks are scaled to the box, all alike.
  const double scale = protocol.jam ? 0.5 * edges[0] / box.scale() : 1.;
  Packing packing;
  const dealii::Point<2> middle = lower + 0.5 * edges;
  for (std::size_t i = 0; i < radius.size(); ++i)
    packing.disks.push_back(
        {dealii::Point<2>(middle[0] + scale * box.disks()[i][0], middle[1] + scale * box.disks()[i][1]),
         scale * (radius[i] - (tight ? allowed_overlap * mean : 0.))});
  return packing;
}

std::vector<double> draw_radii(const PackingRequest &request, Uniform &random)
{
  std::vector<double> radii(request.number);
  for (double &r : radii)
    r = 0.5 * request.sizes.draw(random);
  if (request.fraction > 0.)
  {
    // What pack_disks() takes from the radii is made up for.
    const double taken = request.fraction > loose_fraction ? allowed_overlap * mean_of(radii) : 0.;
    const dealii::Tensor<1, 2> edges = request.upper - request.lower;
    const double scale = std::sqrt(request.fraction * edges[0] * edges[1] / area_of(radii, taken));
    for (double &r : radii)
      r *= scale;
  }
  return radii;
}

Packing make_packing(const PackingRequest &request)
{
  Uniform random(request.seed);
  const std::vector<double> radii = draw_radii(request, random);
  return pack_disks(radii, request.lower, request.upper, random, request.protocol);
}
} // namespace softgrain
