// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/neighbour_list.h>
#include <softgrain/scene/packing.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

namespace softgrain
{
namespace
{
using Place = std::array<double, 2>;

/// Share of area that disks thrown at random reach at once.
constexpr double loose_fraction = 0.40;
/// Share that the length of the box loses in a step, at most and where it counts as jammed.
constexpr double largest_shrinkage = 0.01, jammed_shrinkage = 2e-5;

/// The four sides of a box about the origin.
struct Box
{
  Place half; ///< of the edges

  static constexpr unsigned int n_walls = 4;
  static Place normal(const unsigned int wall)
  {
    const double sign = wall % 2 == 0 ? 1. : -1.;
    return wall < 2 ? Place{sign, 0.} : Place{0., sign};
  }
  double gap(const unsigned int wall, const Place &x, const double radius) const
  {
    const unsigned int d = wall / 2;
    return half[d] + (wall % 2 == 0 ? x[d] : -x[d]) - radius;
  }
};

/// Places without overlap in @p box, the largest disks first.
std::vector<Place> throw_in(const std::vector<double> &radius, const Box &box, Uniform &random)
{
  std::vector<std::uint32_t> order(radius.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return radius[a] > radius[b]; });
  const double cell = 2. * radius[order[0]];
  const int nx = static_cast<int>(2. * box.half[0] / cell) + 1,
            ny = static_cast<int>(2. * box.half[1] / cell) + 1;
  std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(nx) * ny);
  std::vector<Place> places(radius.size());
  for (const std::uint32_t i : order)
    for (unsigned int attempt = 0;; ++attempt)
    {
      if (attempt == 1000000)
        throw InputError("'Packing': the disks do not fit into the box, they are too large for it");
      Place x;
      for (unsigned int d = 0; d < 2; ++d)
        x[d] = (2. * random() - 1.) * (box.half[d] - radius[i]);
      const int cx = static_cast<int>((x[0] + box.half[0]) / cell),
                cy = static_cast<int>((x[1] + box.half[1]) / cell);
      bool overlaps = false;
      for (int a = std::max(0, cx - 1); a <= std::min(nx - 1, cx + 1) && !overlaps; ++a)
        for (int b = std::max(0, cy - 1); b <= std::min(ny - 1, cy + 1) && !overlaps; ++b)
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

/// Shrinks a box with disks in it; velocities are displacements of one step.
class Shrinking
{
public:
  Shrinking(const std::vector<double> &radii, const std::vector<Place> &start, const Box &start_box)
      : radius(radii)
      , places(start)
      , box(start_box)
      , mean(std::accumulate(radii.begin(), radii.end(), 0.) / radii.size())
      , list(radii, {}, {0.2 * mean, 0., 0.5 * mean})
  {
  }

  /// Shrinks by @p factor, just below 1, and keeps the disks apart. @return the deepest overlap left [m].
  double step(const double factor)
  {
    list.update(places);
    contact::DiskBodies bodies;
    contact::DiskContacts rows;
    collect(factor, bodies, rows);
    contact::DiskSolverSettings settings;
    settings.tolerance = 1e-3;
    settings.penetration_tolerance = 1e-4 * mean;
    settings.max_sweeps = 2000;
    contact::solve_disks(bodies, rows, settings);
    for (std::size_t i = 0; i < places.size(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        places[i][d] += bodies.velocity[i][d];
    for (double &edge : box.half)
      edge *= factor;
    return deepest_overlap();
  }

  const std::vector<Place> &disks() const { return places; }
  double scale() const { return box.half[0]; }

  /// Places and box as they were before.
  void restore(const std::vector<Place> &old_places, const double old_scale)
  {
    places = old_places;
    const double factor = old_scale / box.half[0];
    for (double &edge : box.half)
      edge *= factor;
  }

private:
  void collect(const double factor, contact::DiskBodies &bodies, contact::DiskContacts &rows)
  {
    const std::size_t n = places.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      bodies.velocity.push_back({(factor - 1.) * places[i][0], (factor - 1.) * places[i][1]});
      bodies.inverse_mass.push_back(mean * mean / (radius[i] * radius[i]));
    }
    for (unsigned int w = 0; w < Box::n_walls; ++w)
    {
      const Place normal = Box::normal(w);
      const double speed = (1. - factor) * box.half[w / 2];
      bodies.velocity.push_back({speed * normal[0], speed * normal[1]});
      bodies.inverse_mass.push_back(0.);
    }
    // Nothing closes more than the walls do.
    const double reach = std::max(0.1 * mean, 4. * largest_shrinkage * mean);
    rows.colour_start = list.colour_start();
    rows.tile_start.push_back(0);
    for (unsigned int tile = 0; tile < list.n_tiles(); ++tile)
    {
      for (std::uint32_t pair = list.tile_start()[tile]; pair < list.tile_start()[tile + 1]; ++pair)
      {
        const std::uint32_t a = list.a(pair), b = list.b(pair);
        const double dx = places[a][0] - places[b][0], dy = places[a][1] - places[b][1];
        const double distance = std::hypot(dx, dy), gap = distance - radius[a] - radius[b];
        // Disks on top of each other have no direction; any one gets them apart.
        const Place normal = distance > 0. ? Place{dx / distance, dy / distance} : Place{1., 0.};
        if (gap < reach)
          add(rows, a, b, normal, gap);
      }
      rows.tile_start.push_back(rows.a.size());
    }
    for (unsigned int w = 0; w < Box::n_walls; ++w)
      for (std::size_t i = 0; i < n; ++i)
        if (const double gap = box.gap(w, places[i], radius[i]);
            gap < reach + (1. - factor) * box.half[w / 2])
          add(rows, i, n + w, Box::normal(w), gap);
  }

  static void add(contact::DiskContacts &rows,
                  const std::uint32_t a,
                  const std::uint32_t b,
                  const Place &normal,
                  const double gap)
  {
    rows.a.push_back(a);
    rows.b.push_back(b);
    rows.normal.push_back(normal);
    rows.gap_velocity.push_back(gap);
    rows.impulse.push_back(0.);
  }

  double deepest_overlap() const
  {
    double deepest = 0.;
    for (std::size_t pair = 0; pair < list.n_pairs(); ++pair)
    {
      const std::uint32_t a = list.a(pair), b = list.b(pair);
      deepest = std::max(deepest, radius[a] + radius[b] -
                                      std::hypot(places[a][0] - places[b][0], places[a][1] - places[b][1]));
    }
    for (unsigned int w = 0; w < Box::n_walls; ++w)
      for (std::size_t i = 0; i < places.size(); ++i)
        deepest = std::max(deepest, -box.gap(w, places[i], radius[i]));
    return deepest;
  }

  std::vector<double> radius;
  std::vector<Place> places;
  Box box;
  double mean; ///< radius
  contact::NeighbourList list;
};
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
                   const bool patient)
{
  double solid = 0., sum = 0.;
  for (const double r : radius)
  {
    solid += dealii::numbers::PI * r * r;
    sum += r;
  }
  const dealii::Tensor<1, 2> edges = upper - lower;
  const double fraction = solid / (edges[0] * edges[1]);
  std::ostringstream numbers;
  numbers << radius.size() << " disks fill " << fraction << " of the box";
  if (fraction > 0.9)
    throw InputError("'Packing': " + numbers.str() + "; at most about 0.80 is possible");
  const double growth = std::max(1., std::sqrt(fraction / loose_fraction));
  Box box{{0.5 * growth * edges[0], 0.5 * growth * edges[1]}};
  Shrinking shrinking(radius, throw_in(radius, box, random), box);

  // Overlaps are relative to the final radii; a share of them may stay and is taken from the radii at the
  // end.
  const double mean = sum / radius.size(), allowed = 1e-3 * mean, end = 0.5 * edges[0];
  double shrinkage = largest_shrinkage;
  for (bool there = growth == 1.; !there;)
  {
    const std::vector<Place> before = shrinking.disks();
    const double scale = shrinking.scale();
    double overlap = shrinking.step(std::max(end / scale, 1. - shrinkage));
    for (unsigned int rest = 0; overlap > allowed && overlap < 0.5 * mean && rest < 200; ++rest)
      overlap = shrinking.step(1.);
    if (overlap > allowed)
    {
      // Near jamming disks must go long ways for little: a smaller step leaves them time to.
      shrinking.restore(before, scale);
      shrinkage *= 0.3;
      if (!patient || shrinkage < jammed_shrinkage)
        throw InputError("'Packing': the disks jam before they are in the box: " + numbers.str() +
                         "; enlarge the box or use fewer disks");
      continue;
    }
    shrinkage = std::min(largest_shrinkage, 1.2 * shrinkage);
    there = shrinking.scale() <= end * (1. + 1e-12);
  }

  Packing packing;
  const dealii::Point<2> middle = lower + 0.5 * edges;
  for (std::size_t i = 0; i < radius.size(); ++i)
    packing.disks.push_back(
        {dealii::Point<2>(middle[0] + shrinking.disks()[i][0], middle[1] + shrinking.disks()[i][1]),
         radius[i] - (growth == 1. ? 0. : allowed)});
  return packing;
}

Packing make_packing(const PackingRequest &request)
{
  Uniform random(request.seed);
  std::vector<double> radii(request.number);
  for (double &r : radii)
    r = 0.5 * request.sizes.draw(random);
  return pack_disks(radii, request.lower, request.upper, random);
}
} // namespace softgrain
