// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/random.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/neighbour_list.h>
#include <softgrain/scene/body_geometry.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
using Place = std::array<double, 2>;

/// Share of area that random places without overlap reach at once.
constexpr double loose_fraction = 0.40;
/// Share of area of a dense disordered packing of disks in the plane.
constexpr double dense_fraction = 0.84;

/// Radii [m] of a given number of primaries, or of as many as come nearest to @p area [m^2] in all.
std::vector<double> random_radii(const PrimarySettings &settings, const double area, Uniform &random)
{
  std::vector<double> radii;
  double filled = 0.;
  for (;;)
  {
    const double r = 0.5 * settings.sizes.draw(random);
    const double own = dealii::numbers::PI * r * r;
    if (settings.number > 0 ? radii.size() == settings.number : filled + 0.5 * own > area)
      return radii;
    radii.push_back(r);
    filled += own;
  }
}

/// Places without overlap in @p body blown up by @p scale about its centre, largest disks first.
std::vector<Place> loose_places(const BodyDescription<2> &body,
                                const std::vector<double> &radius,
                                const double scale,
                                Uniform &random)
{
  const auto box = bounding_box(body);
  const double cell = 2. * *std::max_element(radius.begin(), radius.end());
  const auto n_cells = [&](const unsigned int d)
  { return static_cast<int>(scale * (box.second[d] - box.first[d]) / cell) + 1; };
  const int nx = n_cells(0), ny = n_cells(1);
  std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(nx) * ny);
  std::vector<std::uint32_t> order(radius.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return radius[a] > radius[b]; });

  std::vector<Place> places(radius.size());
  for (const std::uint32_t i : order)
    for (unsigned int attempt = 0;; ++attempt)
    {
      if (attempt == 1000000)
        throw InputError("the primaries do not fit into body '" + body.name +
                         "': they are too large for its shape");
      dealii::Point<2> inside;
      for (unsigned int d = 0; d < 2; ++d)
        inside[d] = box.first[d] + random() * (box.second[d] - box.first[d]);
      if (depth_inside(body, inside) < 0.)
        continue;
      const Place x = {scale * (inside[0] - body.center[0]), scale * (inside[1] - body.center[1])};
      const auto cell_at = [&](const unsigned int d)
      { return static_cast<int>((x[d] - scale * (box.first[d] - body.center[d])) / cell); };
      const int cx = std::clamp(cell_at(0), 0, nx - 1), cy = std::clamp(cell_at(1), 0, ny - 1);
      bool overlaps = false;
      for (int a = std::max(0, cx - 1); a <= std::min(nx - 1, cx + 1); ++a)
        for (int b = std::max(0, cy - 1); b <= std::min(ny - 1, cy + 1); ++b)
          for (const std::uint32_t j : cells[static_cast<std::size_t>(a) * ny + b])
            overlaps |= std::hypot(x[0] - places[j][0], x[1] - places[j][1]) < radius[i] + radius[j];
      if (overlaps)
        continue;
      places[i] = x;
      cells[static_cast<std::size_t>(cx) * ny + cy].push_back(i);
      break;
    }
  return places;
}

/// Walls that hold nothing: the primaries of an aggregate in the making are alone.
std::vector<MovingWall> no_walls;

Primaries disks_of(const Aggregate &aggregate, const double density)
{
  Primaries disks;
  disks.position = aggregate.position;
  disks.radius = aggregate.radius;
  disks.velocity.assign(aggregate.size(), {0., 0.});
  disks.body.assign(aggregate.size(), 0);
  for (const double r : aggregate.radius)
    disks.mass.push_back(dealii::numbers::PI * r * r * density);
  return disks;
}

/// Draws all places to the origin, each in proportion to its distance, until contacts stop them or @p scale.
void shrink(Aggregate &aggregate, const double scale, const double density, const DynamicsSettings &settings)
{
  DynamicsSettings still = settings;
  still.friction = still.rolling_resistance = still.inner_rolling_resistance = still.restitution = 0.;
  Dynamics dynamics(disks_of(aggregate, density), {}, {}, still);
  dynamics.detect(no_walls);
  const double rate = 0.01;
  const double extent = [&]
  {
    double sum = 0.;
    for (const Place &x : aggregate.position)
      sum += std::hypot(x[0], x[1]);
    return sum;
  }();
  double before = extent;
  for (unsigned int step = 0; step < 2000; ++step)
  {
    Primaries &disks = dynamics.disks();
    // Time has no meaning here: one step of length 1 with velocities that are displacements.
    for (std::size_t i = 0; i < disks.size(); ++i)
      disks.velocity[i] = {-rate * disks.position[i][0], -rate * disks.position[i][1]};
    dynamics.step(1., no_walls, {});
    double now = 0.;
    for (const Place &x : disks.position)
      now += std::hypot(x[0], x[1]);
    if (now <= scale * extent || before - now < 0.05 * rate * before)
      break;
    before = now;
  }
  aggregate.position = dynamics.disks().position;
}

/// Attraction and inelastic contacts until the kinetic energy is small beside what attraction could give.
void relax(Aggregate &aggregate,
           const std::string &name,
           const double density,
           const std::shared_ptr<const Attraction> &attraction,
           const DynamicsSettings &settings)
{
  DynamicsSettings still = settings;
  still.friction = still.rolling_resistance = still.inner_rolling_resistance = still.restitution = 0.;
  Dynamics dynamics(disks_of(aggregate, density), {attraction}, {}, still);
  dynamics.detect(no_walls);
  const double force = attraction->contact_force(), a0 = dynamics.mean_diameter();
  const double dt = 0.05 * attraction_time(a0, density, force);
  const double rest = 1e-7 * force * a0 * aggregate.size();
  const unsigned int most = 20000;
  for (unsigned int step = 0;; ++step)
  {
    dynamics.step(dt, no_walls, {});
    if (step > 20 && dynamics.kinetic_energy() < rest)
      break;
    if (step == most)
    {
      std::ostringstream message;
      message << "the primaries of body '" << name << "' do not come to rest: after " << most
              << " steps their kinetic energy is " << dynamics.kinetic_energy() << " J/m, wanted is " << rest;
      throw ComputationError(message.str());
    }
    // A little drag ends oscillations of the whole that no contact damps.
    for (auto &v : dynamics.disks().velocity)
      for (double &component : v)
        component *= 0.98;
  }
  aggregate.position = dynamics.disks().position;
}

/// Takes away the primaries that reach beyond the outline. @return how many.
std::size_t trim(Aggregate &aggregate, const BodyDescription<2> &body)
{
  Aggregate kept;
  for (std::size_t i = 0; i < aggregate.size(); ++i)
  {
    const dealii::Point<2> x(body.center[0] + aggregate.position[i][0],
                             body.center[1] + aggregate.position[i][1]);
    if (depth_inside(body, x) < aggregate.radius[i])
      continue;
    kept.position.push_back(aggregate.position[i]);
    kept.radius.push_back(aggregate.radius[i]);
  }
  const std::size_t removed = aggregate.size() - kept.size();
  aggregate = kept;
  return removed;
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
  const double shape_area = area(body);
  Aggregate aggregate;
  aggregate.radius = random_radii(settings.primaries, settings.primaries.solid_fraction * shape_area, random);
  if (aggregate.radius.empty())
    throw InputError("not one primary fits into body '" + body.name +
                     "': lower 'Primaries/Largest diameter'");
  double filled = 0.;
  for (const double r : aggregate.radius)
    filled += dealii::numbers::PI * r * r;
  aggregate.position =
      loose_places(body, aggregate.radius, std::sqrt(filled / loose_fraction / shape_area), random);
  if (aggregate.size() > 1)
  {
    const double fraction =
        settings.primaries.number > 0 ? dense_fraction : settings.primaries.solid_fraction;
    shrink(aggregate, std::sqrt(loose_fraction / fraction), density, settings.dynamics);
    if (attraction && attraction->contact_force() > 0.)
      relax(aggregate, body.name, density, attraction, settings.dynamics);
    if (settings.primaries.number == 0)
    {
      // What is taken away leaves dents that attraction smooths; a few rounds settle it.
      for (unsigned int round = 0; trim(aggregate, body) > 0; ++round)
      {
        if (aggregate.size() == 0 || round == 20)
          throw InputError("the primaries do not stay inside of body '" + body.name +
                           "': lower 'Primaries/Solid fraction'");
        if (attraction && attraction->contact_force() > 0.)
          relax(aggregate, body.name, density, attraction, settings.dynamics);
      }
    }
  }
  sort_by_place(aggregate);
  return aggregate;
}
} // namespace softgrain::bpm
