// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/preparation.h>
#include <softgrain/packing/packing.h>
#include <softgrain/packing/shaken_balls.h>
#include <softgrain/packing/shaken_box.h>
#include <softgrain/packing/shrinking_box.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

namespace softgrain
{
namespace
{
/// Share of area that disks thrown at random reach at once.
constexpr double loose_fraction = 0.40;
/// Fraction at which disks jam, about: for what is told of progress alone.
constexpr double jammed_fraction = 0.84;
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
/// Share of their size that grains other than disks lose at the end.
constexpr double grain_slack = 1e-3;

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
bool shrink(ShrinkingBox &box,
            const double end,
            const double mean,
            const PackingProtocol &protocol,
            const Jamming &jamming)
{
  const double allowed = allowed_overlap * mean;
  // Those who are impatient make many small packings, and tell of them themselves.
  std::optional<Preparation> telling;
  if (protocol.patient)
    telling.emplace("the packing", box.disks().size());
  const double begin = box.scale(), expected = begin * std::sqrt(loose_fraction / jammed_fraction);
  const double way = std::log(begin / (protocol.jam ? expected : end));
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
    if (telling)
      telling->reach(std::log(begin / box.scale()) / way);
  }
  return false;
}
/**
 * Disks that have jammed before the box was as small as it is to be, shaken until it is.
 * @throw InputError that says how far they came
 */
void shake_in(ShrinkingBox &box,
              const double end,
              const dealii::Tensor<1, 2> &edges,
              const std::vector<double> &radius,
              const PackingProtocol &protocol,
              Uniform &random,
              const std::string &numbers)
{
  const double taken = allowed_overlap * mean_of(radius);
  const auto filled = [&](const double scale)
  { return area_of(radius, taken) / (std::pow(2. * scale, 2) * edges[1] / edges[0]); };
  double reached = filled(box.scale());
  if (protocol.patient && protocol.friction == 0.)
  {
    // Room to change places, and more than they overlap.
    const double least = *std::min_element(radius.begin(), radius.end());
    box.loosen(1. + std::max(0.06, 1.5 * taken / least));
    ShakenBalls<2> disks(box.disks(), radius, {box.scale(), box.scale() * edges[1] / edges[0]},
                         protocol.periodic);
    if (disks.shrink(end, box.scale(), random))
      return box.restore(disks.places(), disks.scale());
    reached = std::max(reached, filled(disks.scale()));
  }
  std::ostringstream text;
  text.precision(4);
  text << reached;
  throw InputError("'Packing': the disks jam before they are in the box: " + numbers + ", and " + text.str() +
                   " is the most that was reached; ask for less ('Packing fraction', or a larger box), try "
                   "another 'Seed', or take "
                   "'Until jammed' = 'true', which keeps what they reach");
}
} // namespace

double solid_area(const Packing<2> &packing)
{
  double area = 0.;
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
    area += form_of(packing, i).area(packing.balls[i].radius);
  return area;
}

GrainForm2D form_of(const Packing<2> &packing, const std::size_t grain)
{
  return packing.forms.empty() ? GrainForm2D() : packing.forms[grain];
}

Packing<2> pack_disks(const std::vector<double> &radius,
                      const dealii::Point<2> &lower,
                      const dealii::Point<2> &upper,
                      Uniform &random,
                      const PackingProtocol &protocol)
{
  const dealii::Tensor<1, 2> edges = upper - lower;
  const double fraction = area_of(radius) / (edges[0] * edges[1]);
  const auto fill = [&radius](const double share)
  {
    std::ostringstream text;
    text << radius.size() << " disks fill " << share << " of the box";
    return text.str();
  };
  if (fraction > 0.9 && !protocol.jam)
    throw InputError("'Packing': " + fill(fraction) + "; at most about 0.84 is possible");
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
  const double end = protocol.jam ? 0. : 0.5 * edges[0];
  const bool jammed = tight && shrink(box, end, mean, protocol, protocol.jam ? wanted : avoided);
  if (jammed && !protocol.jam)
    shake_in(box, end, edges, radius, protocol, random,
             fill(area_of(radius, allowed_overlap * mean_of(radius)) / (edges[0] * edges[1])));

  // Jammed disks are scaled to the box, all alike.
  const double scale = protocol.jam ? 0.5 * edges[0] / box.scale() : 1.;
  Packing<2> packing;
  const dealii::Point<2> middle = lower + 0.5 * edges;
  for (std::size_t i = 0; i < radius.size(); ++i)
    packing.balls.push_back(
        {dealii::Point<2>(middle[0] + scale * box.disks()[i][0], middle[1] + scale * box.disks()[i][1]),
         scale * (radius[i] - (tight ? allowed_overlap * mean : 0.))});
  return packing;
}

Packing<2>
pack_grains(Packing<2> packing, const dealii::Point<2> &lower, const dealii::Point<2> &upper, Uniform &random)
{
  const dealii::Tensor<1, 2> edges = upper - lower;
  std::vector<double> radii;
  for (const Packing<2>::Ball &disk : packing.balls)
    radii.push_back(disk.radius);
  std::ostringstream numbers;
  numbers << radii.size() << " grains fill " << solid_area(packing) / (edges[0] * edges[1]) << " of the box";
  if (solid_area(packing) > 0.95 * edges[0] * edges[1])
    throw InputError("'Packing': " + numbers.str() + "; at most about 0.85 is possible");
  const double growth = std::max(1., std::sqrt(area_of(radii) / (edges[0] * edges[1]) / loose_fraction));
  const dealii::Point<2> half(0.5 * growth * edges[0], 0.5 * growth * edges[1]);
  const ShrinkingBox thrown(radii, {{half[0], half[1]}, {}, 0.}, random);
  std::vector<ConvexGrain> grains;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    grains.emplace_back(radii[i], packing.forms[i]);
    grains.back().put({thrown.disks()[i][0], thrown.disks()[i][1]}, 2. * dealii::numbers::PI * random());
  }
  ShakenBox box(std::move(grains), half);
  if (!box.shrink(0.5 * edges[0], random))
    throw InputError("'Packing': the grains jam before they are in the box: " + numbers.str() +
                     "; enlarge the box or use fewer grains");
  const dealii::Point<2> middle = lower + 0.5 * edges;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const ConvexGrain &grain = box.grains()[i];
    packing.balls[i].center = middle + (grain.center() - dealii::Point<2>());
    packing.balls[i].radius *= 1. - grain_slack;
    packing.forms[i].short_radius *= 1. - grain_slack;
    const double turns = grain.angle() / (2. * dealii::numbers::PI);
    packing.forms[i].angle =
        packing.forms[i].kind == GrainForm2D::Kind::disk ? 0. : 360. * (turns - std::floor(turns));
  }
  return packing;
}

std::vector<double> draw_radii(const PackingRequest2D &request, Uniform &random)
{
  std::vector<double> radii;
  const std::vector<unsigned int> numbers = request.numbers();
  for (std::size_t c = 0; c < numbers.size(); ++c)
    for (unsigned int i = 0; i < numbers[c]; ++i)
      radii.push_back(0.5 * (request.classes[c].smallest +
                             random() * (request.classes[c].largest - request.classes[c].smallest)));
  while (request.classes.empty() && radii.size() < request.number)
    radii.push_back(0.5 * request.sizes.draw(random));
  if (request.fraction > 0.)
  {
    // What pack_disks() takes from the radii is made up for.
    const bool disks = request.only_disks();
    const double taken = disks && request.fraction > loose_fraction ? allowed_overlap * mean_of(radii) : 0.;
    const dealii::Tensor<1, 2> edges = request.upper - request.lower;
    const double scale = (disks ? 1. : 1. / (1. - grain_slack)) *
                         std::sqrt(request.fraction * edges[0] * edges[1] / area_of(radii, taken));
    for (double &r : radii)
      r *= scale;
  }
  return radii;
}

namespace
{
/// The class of every grain; empty without classes.
std::vector<const GrainClass2D *> classes_of(const PackingRequest2D &request)
{
  std::vector<const GrainClass2D *> result;
  const std::vector<unsigned int> numbers = request.numbers();
  for (std::size_t c = 0; c < numbers.size(); ++c)
    result.insert(result.end(), numbers[c], &request.classes[c]);
  return result;
}

/// Grains with the areas of disks of these radii.
Packing<2> draw_forms(const std::vector<double> &radii,
                      const GrainMix2D &mix,
                      const std::vector<const GrainClass2D *> &classes,
                      Uniform &random)
{
  Packing<2> packing;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const double radius = radii[i];
    GrainForm2D form;
    form.kind = mix.kinds[static_cast<std::size_t>(mix.kinds.size() * random())];
    if (!classes.empty() && classes[i]->kind)
      form.kind = *classes[i]->kind;
    const double ratio = mix.least_ratio + (mix.greatest_ratio - mix.least_ratio) * random();
    const unsigned int corners =
        mix.least_corners + static_cast<unsigned int>((mix.most_corners - mix.least_corners + 1) * random());
    form.corners = form.kind == GrainForm2D::Kind::polygon ? corners : 0;
    form.short_radius = form.kind == GrainForm2D::Kind::disk ? 1. : ratio;
    const double long_radius = radius * std::sqrt(dealii::numbers::PI / form.area(1.));
    form.short_radius *= long_radius;
    packing.balls.push_back({dealii::Point<2>(), long_radius});
    packing.forms.push_back(form);
  }
  return packing;
}
} // namespace

Packing<2> make_packing(const PackingRequest2D &request)
{
  Uniform random(request.seed);
  const std::vector<double> radii = draw_radii(request, random);
  const std::vector<const GrainClass2D *> classes = classes_of(request);
  Packing<2> packing = request.only_disks()
                           ? pack_disks(radii, request.lower, request.upper, random, request.protocol)
                           : pack_grains(draw_forms(radii, request.mix, classes, random), request.lower,
                                         request.upper, random);
  for (const GrainClass2D *const one : classes)
    if (!one->material.empty())
      packing.materials.push_back(one->material);
  return packing;
}
} // namespace softgrain
