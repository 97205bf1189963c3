// SPDX-License-Identifier: LGPL-2.1-or-later
// Packings of disks between four walls for the tests of the disk kernel.
#ifndef softgrain_tests_contact_packing_h
#define softgrain_tests_contact_packing_h

#include <softgrain/contact/disk_system.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Disks in the box [0, width] x [0, height].
struct Packing
{
  double width = 0., height = 0.;
  std::vector<std::array<double, 2>> centre;
  std::vector<double> radius;

  std::size_t size() const { return radius.size(); }
  double largest() const { return *std::max_element(radius.begin(), radius.end()); }
};

/// Reads lines `N width height` and `x y radius aggregate`.
inline Packing read_packing(const std::string &path)
{
  std::ifstream file(path);
  std::size_t n = 0;
  Packing packing;
  if (!(file >> n >> packing.width >> packing.height))
    throw std::runtime_error(path + ": no packing");
  packing.centre.resize(n);
  packing.radius.resize(n);
  int aggregate;
  for (std::size_t i = 0; i < n; ++i)
    if (!(file >> packing.centre[i][0] >> packing.centre[i][1] >> packing.radius[i] >> aggregate))
      throw std::runtime_error(path + ": ends too early");
  return packing;
}

/// Disks on a triangular lattice with radii that vary by @p spread and are @p closeness of what would touch.
inline Packing lattice_packing(const unsigned int n_x,
                               const unsigned int n_y,
                               const double spread = 0.1,
                               const double closeness = 1.)
{
  Packing packing;
  const double row = std::sqrt(0.75);
  unsigned int state = 12345;
  for (unsigned int j = 0; j < n_y; ++j)
    for (unsigned int i = 0; i < n_x; ++i)
    {
      state = state * 1664525u + 1013904223u;
      packing.centre.push_back({{0.5 + i + 0.5 * (j % 2), 0.5 + j * row}});
      packing.radius.push_back(0.5 * closeness * (1. - spread * (state >> 8) / double(1u << 24)));
    }
  packing.width = n_x + 0.5;
  packing.height = 1. + (n_y - 1) * row;
  return packing;
}

/// Sorts the disks by cells of two diameters, row by row, as a model would.
inline void sort_packing(Packing &packing)
{
  const double cell = 4. * packing.largest();
  std::vector<std::pair<std::array<long, 2>, std::size_t>> key(packing.size());
  for (std::size_t i = 0; i < packing.size(); ++i)
    key[i] = {{{long(packing.centre[i][0] / cell), long(packing.centre[i][1] / cell)}}, i};
  std::sort(key.begin(), key.end());
  Packing sorted = packing;
  for (std::size_t i = 0; i < packing.size(); ++i)
  {
    sorted.centre[i] = packing.centre[key[i].second];
    sorted.radius[i] = packing.radius[key[i].second];
  }
  packing = sorted;
}

/// Bodies and contacts of a packing; walls left, right, bottom, top are the last four bodies.
struct DiskSystem
{
  softgrain::contact::DiskBodies bodies;
  softgrain::contact::DiskContacts contacts;
};

struct SystemSettings
{
  double density = 1.;   ///< of a disk
  double reach = 0.02;   ///< gap up to which a pair is a contact, in mean radii (0.5)
  double time_step = 1.; ///< turns gaps into velocities
  double friction = -1.; ///< below 0: no rotations
  double rolling = -1.;  ///< below 0: none
};

/**
 * Contacts of a packing, in vertical strips of colours 0 and 1. A strip is wider than two of the largest
 * diameters with the reach, and has the contacts whose lefter disk's centre lies in it; its disks lie in it
 * or less than one diameter to the right, so two strips of one colour have none in common.
 */
inline DiskSystem make_system(const Packing &packing, const SystemSettings &settings)
{
  DiskSystem system;
  auto &bodies = system.bodies;
  auto &contacts = system.contacts;
  const std::size_t n = packing.size();
  const double pi = std::acos(-1.), reach = settings.reach * 0.5;
  bodies.velocity.assign(n + 4, {{0., 0.}});
  const bool rotate = settings.friction >= 0.;
  for (std::size_t i = 0; i < n + 4; ++i)
  {
    const double mass = i < n ? settings.density * pi * packing.radius[i] * packing.radius[i] : 0.;
    bodies.inverse_mass.push_back(i < n ? 1. / mass : 0.);
    if (rotate)
    {
      bodies.angular_velocity.push_back(0.);
      bodies.inverse_inertia.push_back(i < n ? 2. / (mass * packing.radius[i] * packing.radius[i]) : 0.);
    }
  }
  const double cell = 2. * packing.largest() + reach, strip_width = 2.01 * cell;
  const long n_x = std::max(1L, long(packing.width / cell)), n_y = std::max(1L, long(packing.height / cell));
  const auto cell_of = [&](const std::size_t i, const unsigned int d)
  {
    const long k = packing.centre[i][d] / cell;
    return std::min(d == 0 ? n_x - 1 : n_y - 1, std::max(0L, k));
  };
  std::vector<std::vector<std::uint32_t>> cells(n_x * n_y);
  for (std::size_t i = 0; i < n; ++i)
    cells[cell_of(i, 0) * n_y + cell_of(i, 1)].push_back(i);

  struct Pair
  {
    long strip, band;
    std::uint32_t a, b;
    double gap;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < n; ++i)
    for (long x = std::max(0L, cell_of(i, 0) - 1); x <= std::min(n_x - 1, cell_of(i, 0) + 1); ++x)
      for (long y = std::max(0L, cell_of(i, 1) - 1); y <= std::min(n_y - 1, cell_of(i, 1) + 1); ++y)
        for (const std::uint32_t j : cells[x * n_y + y])
          if (j > i)
          {
            const double gap = std::hypot(packing.centre[i][0] - packing.centre[j][0],
                                          packing.centre[i][1] - packing.centre[j][1]) -
                               packing.radius[i] - packing.radius[j];
            if (gap < reach)
            {
              const bool i_left = packing.centre[i][0] < packing.centre[j][0];
              const std::uint32_t a = i_left ? i : j, b = i_left ? j : i;
              pairs.push_back(
                  {long(packing.centre[a][0] / strip_width), long(packing.centre[a][1] / cell), a, b, gap});
            }
          }
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair &p, const Pair &q)
            {
              return std::array<long, 5>{{p.strip % 2, p.strip, p.band, p.a, p.b}} <
                     std::array<long, 5>{{q.strip % 2, q.strip, q.band, q.a, q.b}};
            });
  const auto add = [&](const std::uint32_t a, const std::uint32_t b, const std::array<double, 2> normal,
                       const double gap, const double arm_b)
  {
    contacts.a.push_back(a);
    contacts.b.push_back(b);
    contacts.normal.push_back(normal);
    contacts.gap_velocity.push_back(std::max(0., gap) / settings.time_step);
    contacts.impulse.push_back(0.);
    if (rotate)
    {
      contacts.friction.push_back(settings.friction);
      contacts.arm_a.push_back(packing.radius[a]);
      contacts.arm_b.push_back(arm_b);
      contacts.tangential_impulse.push_back(0.);
      if (settings.rolling >= 0.)
      {
        contacts.rolling.push_back(settings.rolling);
        contacts.rolling_impulse.push_back(0.);
      }
    }
  };
  long strip = -1;
  for (const Pair &pair : pairs)
  {
    if (contacts.colour_start.empty() || (strip % 2 == 0 && pair.strip % 2 == 1))
      contacts.colour_start.push_back(contacts.tile_start.size());
    if (pair.strip != strip)
      contacts.tile_start.push_back(contacts.size());
    strip = pair.strip;
    const double distance = pair.gap + packing.radius[pair.a] + packing.radius[pair.b];
    add(pair.a, pair.b,
        {{(packing.centre[pair.a][0] - packing.centre[pair.b][0]) / distance,
          (packing.centre[pair.a][1] - packing.centre[pair.b][1]) / distance}},
        pair.gap, packing.radius[pair.b]);
  }
  contacts.colour_start.push_back(contacts.tile_start.size());
  if (contacts.colour_start.size() == 1) // no pair
    contacts.colour_start.insert(contacts.colour_start.begin(), 0);
  contacts.tile_start.push_back(contacts.size());
  for (std::uint32_t wall = 0; wall < 4; ++wall)
    for (std::size_t i = 0; i < n; ++i)
    {
      const unsigned int d = wall / 2;
      const double side = d == 0 ? packing.width : packing.height;
      const double gap =
          (wall % 2 == 0 ? packing.centre[i][d] : side - packing.centre[i][d]) - packing.radius[i];
      std::array<double, 2> normal = {{0., 0.}};
      normal[d] = wall % 2 == 0 ? 1. : -1.;
      if (gap < reach)
        add(i, n + wall, normal, gap, 0.);
    }
  return system;
}

/// Lets all walls of a system move inwards; the box shrinks like the affine field that the disks follow when
/// @p affine.
inline void squeeze(DiskSystem &system, const Packing &packing, const double speed, const bool affine)
{
  const std::size_t n = packing.size();
  auto &v = system.bodies.velocity;
  for (std::size_t i = 0; i < n; ++i)
    for (unsigned int d = 0; d < 2; ++d)
      v[i][d] =
          affine ? speed * (1. - 2. * packing.centre[i][d] / (d == 0 ? packing.width : packing.height)) : 0.;
  v[n] = {{speed, 0.}};
  v[n + 1] = {{-speed, 0.}};
  v[n + 2] = {{0., speed}};
  v[n + 3] = {{0., -speed}};
}

/// Walls that close in on disks with random velocities; the right and the upper one have a mass.
inline DiskSystem
random_system(const Packing &packing, const SystemSettings &settings, const unsigned int seed)
{
  DiskSystem system = make_system(packing, settings);
  squeeze(system, packing, 0.1, false);
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0., 0.1);
  for (std::size_t i = 0; i < packing.size(); ++i)
    system.bodies.velocity[i] = {{normal(generator), normal(generator)}};
  system.bodies.inverse_mass[packing.size() + 1] = 0.1;
  system.bodies.inverse_mass[packing.size() + 3] = 0.02;
  return system;
}

#endif
