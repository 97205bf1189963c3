// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/random.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/settling.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/packing/packing.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
/// Shares of area of the packing that aggregates are cut from, the first that can be packed: few disks of one
/// size do not fill a box well, and 0.78 is hard to reach for any. Attraction makes it denser.
constexpr double packed_fractions[] = {0.76, 0.74, 0.70, 0.60, 0.50};

/// A packing with room for @p half [m] to all sides of the origin. @p radii come out.
Packing<2> pack_around(const dealii::Tensor<1, 2> &half,
                       const SizeDistribution &sizes,
                       std::vector<double> &radii,
                       Uniform &random)
{
  for (const double fraction : packed_fractions)
  {
    const double wanted = fraction * 4. * half[0] * half[1];
    double filled = 0.;
    for (radii.clear(); filled < wanted; filled += dealii::numbers::PI * radii.back() * radii.back())
      radii.push_back(0.5 * sizes.draw(random));
    const dealii::Tensor<1, 2> corner = std::sqrt(filled / wanted) * half;
    PackingProtocol impatient;
    impatient.patient = false;
    try
    {
      return pack_disks(radii, dealii::Point<2>(-corner), dealii::Point<2>(corner), random, impatient);
    }
    catch (const InputError &)
    {
      if (fraction == packed_fractions[std::size(packed_fractions) - 1])
        throw;
    }
  }
  return {};
}

/// Share of the shape that the primaries of a body fill before those that reach beyond the outline are taken
/// away.
constexpr double filled_fraction = 0.82;

/// The primaries of a packing larger than @p body that lie deepest inside of its outline: a given number, or
/// all that lie wholly inside.
Aggregate cut_out(const BodyDescription<2> &body, const PrimarySettings &settings, Uniform &random)
{
  const auto box = body.shape->bounding_box();
  const dealii::Tensor<1, 2> edges = box.second - box.first;
  // A given number may need more room than the shape has.
  const double enlargement = settings.number > 0
                                 ? std::max(1., std::sqrt(settings.number * settings.sizes.mean_area() /
                                                          (0.75 * body.shape->area())))
                                 : 1.;
  dealii::Tensor<1, 2> half;
  for (unsigned int d = 0; d < 2; ++d)
    half[d] = 0.55 * enlargement * edges[d] + 2. * settings.sizes.largest;
  check_number(body.name, 4. * half[0] * half[1] / settings.sizes.mean_area());
  const dealii::Tensor<1, 2> middle = box.first + 0.5 * edges - body.center;
  std::vector<double> radii;
  const Packing<2> packing = pack_around(half, settings.sizes, radii, random);

  std::vector<std::pair<double, std::uint32_t>> depth;
  for (std::uint32_t i = 0; i < packing.balls.size(); ++i)
    depth.emplace_back(
        radii[i] - body.shape->depth(body.center + middle + (packing.balls[i].center - dealii::Point<2>())),
        i);
  std::sort(depth.begin(), depth.end());
  const double wanted = filled_fraction * body.shape->area();
  double filled = 0.;
  Aggregate aggregate;
  for (const auto &[outside, i] : depth)
  {
    if (settings.number > 0 ? aggregate.size() == settings.number : filled >= wanted)
      break;
    filled += dealii::numbers::PI * radii[i] * radii[i];
    const dealii::Tensor<1, 2> x = packing.balls[i].center - dealii::Point<2>() + middle;
    aggregate.position.push_back({x[0], x[1]});
    aggregate.radius.push_back(radii[i]);
  }
  return aggregate;
}

/// Takes away the primaries that reach beyond the outline. @return whether there were any.
bool trim(Aggregate &aggregate, const BodyDescription<2> &body)
{
  Aggregate kept;
  for (std::size_t i = 0; i < aggregate.size(); ++i)
  {
    const dealii::Point<2> x(body.center[0] + aggregate.position[i][0],
                             body.center[1] + aggregate.position[i][1]);
    if (body.shape->depth(x) < aggregate.radius[i])
      continue;
    kept.position.push_back(aggregate.position[i]);
    kept.radius.push_back(aggregate.radius[i]);
  }
  const bool trimmed = kept.size() < aggregate.size();
  aggregate = kept;
  return trimmed;
}

/// Puts the middle of the aggregate where that of its shape is, so that it is met alike from all sides.
void center(Aggregate &aggregate, const BodyDescription<2> &body)
{
  const auto box = body.shape->bounding_box();
  for (unsigned int d = 0; d < 2; ++d)
  {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t i = 0; i < aggregate.size(); ++i)
    {
      low = std::min(low, aggregate.position[i][d] - aggregate.radius[i]);
      high = std::max(high, aggregate.position[i][d] + aggregate.radius[i]);
    }
    const double shift = 0.5 * (box.first[d] + box.second[d]) - body.center[d] - 0.5 * (low + high);
    for (std::array<double, 2> &x : aggregate.position)
      x[d] += shift;
  }
}

/// Neighbours in space become neighbours in memory.
void sort_by_place(Aggregate &aggregate)
{
  std::vector<std::uint32_t> order(aggregate.size());
  std::iota(order.begin(), order.end(), 0);
  const double width = 8. * *std::max_element(aggregate.radius.begin(), aggregate.radius.end());
  const auto key = [&](const std::uint32_t i)
  { return std::make_pair(std::floor(aggregate.position[i][0] / width), aggregate.position[i][1]); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  Aggregate sorted;
  for (const std::uint32_t i : order)
  {
    sorted.position.push_back(aggregate.position[i]);
    sorted.radius.push_back(aggregate.radius[i]);
  }
  aggregate = sorted;
}
} // namespace

void check_number(const std::string &body, const double n_primaries)
{
  constexpr double most = 1e8;
  if (n_primaries <= most)
    return;
  std::ostringstream message;
  message << "'Primaries/Largest diameter': the sizes of the primaries and of body '" << body
          << "' do not go together: it would be cut from " << n_primaries << " primaries, at most " << most
          << " are allowed";
  throw InputError(message.str());
}

double attraction_time(const double diameter, const double density, const double contact_force)
{
  const double mass = 0.25 * dealii::numbers::PI * diameter * diameter * density;
  return std::sqrt(mass * diameter / contact_force);
}

Aggregate make_aggregate(const BodyDescription<2> &body,
                         const double density,
                         const std::shared_ptr<const Attraction> &attraction,
                         const Settings &settings,
                         const std::uint64_t seed)
{
  Uniform random(seed);
  Aggregate aggregate = cut_out(body, settings.primaries, random);
  Aggregate fitting = aggregate;
  trim(fitting, body);
  const bool attracted = attraction && attraction->contact_force() > 0.;
  const bool trims = settings.primaries.number == 0;
  Settling how = trims ? Settling::roughly : Settling::wholly;
  for (bool done = false; !done;)
  {
    if (aggregate.size() > 1 && attracted)
      settle(aggregate, body.name, density, attraction, how);
    center(aggregate, body);
    // Attraction smooths the dents that are left; a few rounds settle it.
    const bool trimmed = trims && trim(aggregate, body);
    if (aggregate.size() == 0)
      throw InputError(fitting.size() == 0
                           ? "not one primary fits into body '" + body.name +
                                 "': lower 'Primaries/Largest diameter'"
                           : "the attraction of its " + std::to_string(fitting.size()) +
                                 " primaries draws body '" + body.name +
                                 "' together until none of them lies within its outline: make it "
                                 "thicker, or lower 'Primaries/Largest diameter'");
    done = !trimmed && how == Settling::wholly;
    if (!trimmed)
      how = Settling::wholly;
  }
  sort_by_place(aggregate);
  return aggregate;
}
} // namespace softgrain::bpm
