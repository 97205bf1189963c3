// SPDX-License-Identifier: LGPL-2.1-or-later
// Random packings in space.
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>
#include <softgrain/packing/shaken_balls.h>
#include <softgrain/packing/thrown_balls.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
/// Share of volume that balls thrown at random reach at once.
constexpr double loose_fraction = 0.25;
/// Share from which on balls are shaken for long, as they hardly find ways to lie closer.
constexpr double dense_fraction = 0.55;
/// What balls of one size fill at most, in order.
constexpr double largest_fraction = 0.74;

double volume_of(const std::vector<double> &radii)
{
  double volume = 0.;
  for (const double r : radii)
    volume += 4. / 3. * dealii::numbers::PI * r * r * r;
  return volume;
}

double volume_of_box(const dealii::Point<3> &lower, const dealii::Point<3> &upper)
{
  const dealii::Tensor<1, 3> edges = upper - lower;
  return edges[0] * edges[1] * edges[2];
}

std::string too_dense(const std::size_t number, const double fraction)
{
  std::ostringstream text;
  text << "'Packing': " << number << " balls fill " << fraction
       << " of the box; at most about 0.64 is possible";
  return text.str();
}
} // namespace

double solid_volume(const Packing<3> &packing)
{
  std::vector<double> radii;
  for (const Packing<3>::Ball &ball : packing.balls)
    radii.push_back(ball.radius);
  return volume_of(radii);
}

Packing<3> pack_balls(const std::vector<double> &radii,
                      const dealii::Point<3> &lower,
                      const dealii::Point<3> &upper,
                      Uniform &random,
                      const std::array<bool, 3> &periodic)
{
  const dealii::Tensor<1, 3> edges = upper - lower;
  for (unsigned int d = 0; d < 3; ++d)
    if (periodic[d] && edges[d] < 6. * *std::max_element(radii.begin(), radii.end()))
      throw InputError("'Packing': a periodic box must be wider than three of its largest balls");
  const double fraction = volume_of(radii) / volume_of_box(lower, upper);
  if (fraction > largest_fraction)
    throw InputError(too_dense(radii.size(), fraction));
  const double growth = std::max(1., std::cbrt(fraction / loose_fraction)), end = 0.5 * edges[0];
  const std::array<double, 3> half = {
      {0.5 * growth * edges[0], 0.5 * growth * edges[1], 0.5 * growth * edges[2]}};
  ShakenBalls<3> shaken(thrown_balls<3>(radii, half, periodic, random), radii, half, periodic);
  if (!shaken.shrink(end, end * std::cbrt(fraction / dense_fraction), random))
  {
    std::ostringstream text;
    text.precision(4);
    text << "'Packing': the balls jam before they are in the box: " << radii.size() << " balls fill "
         << fraction << " of the box, and " << fraction * std::pow(end / shaken.scale(), 3)
         << " is the most that was reached; ask for less ('Packing fraction', or a larger box)";
    throw InputError(text.str());
  }
  Packing<3> packing;
  const dealii::Point<3> middle = lower + 0.5 * edges;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const std::array<double, 3> &place = shaken.places()[i];
    packing.balls.push_back({middle + dealii::Tensor<1, 3>({place[0], place[1], place[2]}), radii[i]});
  }
  return packing;
}

std::vector<double> draw_radii(const PackingRequest3D &request, Uniform &random)
{
  std::vector<double> radii;
  for (unsigned int i = 0; i < request.number; ++i)
    radii.push_back(0.5 * request.sizes.draw(random));
  if (request.fraction > 0.)
  {
    const double scale =
        std::cbrt(request.fraction * volume_of_box(request.lower, request.upper) / volume_of(radii));
    for (double &r : radii)
      r *= scale;
  }
  return radii;
}

Packing<3> make_packing(const PackingRequest3D &request)
{
  Uniform random(request.seed);
  const std::vector<double> radii = draw_radii(request, random);
  return pack_balls(radii, request.lower, request.upper, random, request.periodic);
}
} // namespace softgrain
