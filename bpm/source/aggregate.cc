// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/random.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/settling.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/packing/packing.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <type_traits>

namespace softgrain::bpm
{
template <>
double size_of_primary<2>(const double radius)
{
  return dealii::numbers::PI * radius * radius;
}

template <>
double size_of_primary<3>(const double radius)
{
  return 4. / 3. * dealii::numbers::PI * radius * radius * radius;
}

namespace
{
/// Shares of the packing that aggregates are cut from, the first that can be packed: few disks of one size do
/// not fill a box well, and 0.78 is hard to reach for any. Attraction makes it denser.
constexpr double packed_fractions[] = {0.76, 0.74, 0.70, 0.60, 0.50};
/// The same of balls, which are thrown at random: to shake them until they are dense takes long. Those of a
/// larger body are drawn together instead.
constexpr double packed_in_space[] = {0.25, 0.2};

/// Edge of a box of this size.
template <int dim>
double root(const double size)
{
  return dim == 2 ? std::sqrt(size) : std::cbrt(size);
}

Packing<2> pack(const std::vector<double> &radii,
                const dealii::Point<2> &lower,
                const dealii::Point<2> &upper,
                Uniform &random)
{
  PackingProtocol impatient;
  impatient.patient = false;
  return pack_disks(radii, lower, upper, random, impatient);
}

Packing<3> pack(const std::vector<double> &radii,
                const dealii::Point<3> &lower,
                const dealii::Point<3> &upper,
                Uniform &random)
{
  return pack_balls(radii, lower, upper, random);
}

/// A packing with room for @p half [m] to all sides of the origin. @p radii come out.
template <int dim, std::size_t n>
Packing<dim> pack_around(const double (&fractions)[n],
                         const dealii::Tensor<1, dim> &half,
                         const SizeDistribution &sizes,
                         std::vector<double> &radii,
                         Uniform &random)
{
  for (const double fraction : fractions)
  {
    double wanted = fraction;
    for (unsigned int d = 0; d < dim; ++d)
      wanted *= 2. * half[d];
    double filled = 0.;
    for (radii.clear(); filled < wanted; filled += size_of_primary<dim>(radii.back()))
      radii.push_back(0.5 * sizes.draw(random));
    const dealii::Tensor<1, dim> corner = root<dim>(filled / wanted) * half;
    try
    {
      return pack(radii, dealii::Point<dim>(-corner), dealii::Point<dim>(corner), random);
    }
    catch (const InputError &)
    {
      if (fraction == fractions[n - 1])
        throw;
    }
  }
  return {};
}

/// Share of the shape that the primaries of a body fill before those that reach beyond the outline are taken
/// away; that of balls is what attraction makes of them in a large ball.
template <int dim>
constexpr double filled_fraction = dim == 2 ? 0.82 : 0.66;

/// How much larger than its shape an aggregate is cut out.
template <int dim>
double looseness()
{
  return dim == 2 ? 1. : std::cbrt(filled_fraction<3> / packed_in_space[0]);
}

double mean_size(const SizeDistribution &sizes, std::integral_constant<int, 2>)
{
  return sizes.mean_area();
}

double mean_size(const SizeDistribution &sizes, std::integral_constant<int, 3>)
{
  // The mean over equal shares.
  constexpr unsigned int n = 2000;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
    sum += size_of_primary<3>(0.5 * sizes.quantile((i + 0.5) / n)) / n;
  return sum;
}

double size_of_shape(const Shape<2> &shape)
{
  return shape.area();
}

double size_of_shape(const Shape<3> &shape)
{
  return shape.volume();
}

/// The primaries of a packing larger than @p body that lie deepest inside of its outline: a given number, or
/// all that lie wholly inside.
template <int dim>
Aggregate<dim> cut_out(const BodyDescription<dim> &body, const PrimarySettings &settings, Uniform &random)
{
  const auto box = body.shape->bounding_box();
  const dealii::Tensor<1, dim> edges = box.second - box.first;
  const double of_primary = mean_size(settings.sizes, std::integral_constant<int, dim>()),
               of_shape = size_of_shape(*body.shape);
  // A given number may need more room than the shape has.
  constexpr double dense = dim == 2 ? 0.75 : filled_fraction<3>;
  double enlargement =
      settings.number > 0 ? std::max(1., root<dim>(settings.number * of_primary / (dense * of_shape))) : 1.;
  const double loose = looseness<dim>();
  enlargement *= loose;
  dealii::Tensor<1, dim> half;
  double room = 1.;
  for (unsigned int d = 0; d < dim; ++d)
  {
    half[d] = 0.55 * enlargement * edges[d] + 2. * settings.sizes.largest;
    room *= 2. * half[d];
  }
  check_number(body.name, room / of_primary);
  const dealii::Tensor<1, dim> middle = box.first + 0.5 * edges - body.center;
  std::vector<double> radii;
  Packing<dim> packing;
  if constexpr (dim == 2)
    packing = pack_around<dim>(packed_fractions, half, settings.sizes, radii, random);
  else
    packing = pack_around<dim>(packed_in_space, half, settings.sizes, radii, random);

  std::vector<std::pair<double, std::uint32_t>> depth;
  for (std::uint32_t i = 0; i < packing.balls.size(); ++i)
    depth.emplace_back(
        radii[i] - loose * body.shape->depth(body.center + middle +
                                             (packing.balls[i].center - dealii::Point<dim>()) / loose),
        i);
  std::sort(depth.begin(), depth.end());
  const double wanted = filled_fraction<dim> * of_shape;
  double filled = 0.;
  Aggregate<dim> aggregate;
  for (const auto &[outside, i] : depth)
  {
    if (settings.number > 0 ? aggregate.size() == settings.number : filled >= wanted)
      break;
    filled += size_of_primary<dim>(radii[i]);
    const dealii::Tensor<1, dim> x = packing.balls[i].center - dealii::Point<dim>() + loose * middle;
    aggregate.position.emplace_back();
    for (unsigned int d = 0; d < dim; ++d)
      aggregate.position.back()[d] = x[d];
    aggregate.radius.push_back(radii[i]);
  }
  return aggregate;
}

/// Takes away the primaries that reach beyond the outline. @return whether there were any.
template <int dim>
bool trim(Aggregate<dim> &aggregate, const BodyDescription<dim> &body)
{
  Aggregate<dim> kept;
  for (std::size_t i = 0; i < aggregate.size(); ++i)
  {
    dealii::Point<dim> x = body.center;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] += aggregate.position[i][d];
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
template <int dim>
void center(Aggregate<dim> &aggregate, const BodyDescription<dim> &body)
{
  const auto box = body.shape->bounding_box();
  for (unsigned int d = 0; d < dim; ++d)
  {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t i = 0; i < aggregate.size(); ++i)
    {
      low = std::min(low, aggregate.position[i][d] - aggregate.radius[i]);
      high = std::max(high, aggregate.position[i][d] + aggregate.radius[i]);
    }
    const double shift = 0.5 * (box.first[d] + box.second[d]) - body.center[d] - 0.5 * (low + high);
    for (std::array<double, dim> &x : aggregate.position)
      x[d] += shift;
  }
}

/// Neighbours in space become neighbours in memory.
template <int dim>
void sort_by_place(Aggregate<dim> &aggregate)
{
  std::vector<std::uint32_t> order(aggregate.size());
  std::iota(order.begin(), order.end(), 0);
  const double width = 8. * *std::max_element(aggregate.radius.begin(), aggregate.radius.end());
  // By slabs, in space by columns in them.
  const auto key = [&](const std::uint32_t i)
  {
    std::array<double, dim> place = aggregate.position[i];
    for (unsigned int d = 0; d + 1 < dim; ++d)
      place[d] = std::floor(place[d] / width);
    return place;
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  Aggregate<dim> sorted;
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

template <int dim>
double attraction_time(const double diameter, const double density, const double contact_force)
{
  return std::sqrt(size_of_primary<dim>(0.5 * diameter) * density * diameter / contact_force);
}

template <int dim>
Aggregate<dim> make_aggregate(const BodyDescription<dim> &body,
                              const double density,
                              const std::shared_ptr<const Attraction> &attraction,
                              const Settings &settings,
                              const std::uint64_t seed)
{
  Uniform random(seed);
  Aggregate<dim> aggregate = cut_out(body, settings.primaries, random);
  if constexpr (dim == 3)
    draw_together(aggregate, looseness<dim>());
  Aggregate<dim> fitting = aggregate;
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

template double attraction_time<2>(double, double, double);
template double attraction_time<3>(double, double, double);
template Aggregate<2> make_aggregate(const BodyDescription<2> &,
                                     double,
                                     const std::shared_ptr<const Attraction> &,
                                     const Settings &,
                                     std::uint64_t);
template Aggregate<3> make_aggregate(const BodyDescription<3> &,
                                     double,
                                     const std::shared_ptr<const Attraction> &,
                                     const Settings &,
                                     std::uint64_t);
} // namespace softgrain::bpm
