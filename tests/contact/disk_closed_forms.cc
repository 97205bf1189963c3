// SPDX-License-Identifier: LGPL-2.1-or-later
// Disks whose impulses are known: collisions, a column, pyramids, a block and a disk on an incline, rolling
// resistance.
#include "reference.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/contact/disk_solver.h>

#include <algorithm>
#include <iostream>

using namespace softgrain::contact;

namespace
{
/// A few disks and walls; every contact may share bodies with every other, so they are one tile.
struct Scene
{
  DiskBodies bodies;
  DiskContacts contacts;

  Scene(const bool rotate, const bool rolls) : rotate(rotate), rolls(rolls) {}

  std::uint32_t add_body(const std::array<double, 2> &v, const double mass, const double inertia = 0.)
  {
    bodies.velocity.push_back(v);
    bodies.inverse_mass.push_back(mass > 0. ? 1. / mass : 0.);
    if (rotate)
    {
      bodies.angular_velocity.push_back(0.);
      bodies.inverse_inertia.push_back(inertia > 0. ? 1. / inertia : 0.);
    }
    return bodies.size() - 1;
  }

  /// Contacts with walls have to come last.
  void add_contact(const std::uint32_t a,
                   const std::uint32_t b,
                   const std::array<double, 2> &normal,
                   const bool wall,
                   const double mu = 0.,
                   const double rolling = 0.)
  {
    contacts.a.push_back(a);
    contacts.b.push_back(b);
    contacts.normal.push_back(normal);
    contacts.gap_velocity.push_back(0.);
    contacts.impulse.push_back(0.);
    if (rotate)
    {
      contacts.friction.push_back(mu);
      contacts.arm_a.push_back(radius);
      contacts.arm_b.push_back(radius);
      contacts.tangential_impulse.push_back(0.);
    }
    if (rolls)
    {
      contacts.rolling.push_back(rolling);
      contacts.rolling_impulse.push_back(0.);
    }
    n_pairs += !wall;
  }

  DiskSolverReport solve()
  {
    contacts.tile_start = {0, n_pairs};
    contacts.colour_start = {0, 1};
    DiskSolverSettings settings;
    settings.tolerance = 1e-13;
    settings.wall_tolerance = 1e-12;
    settings.max_sweeps = 200000;
    return solve_disks(bodies, contacts, settings);
  }

  static constexpr double radius = 0.5;

private:
  bool rotate, rolls;
  unsigned int n_pairs = 0;
};

void print(const std::string &title, const double found, const double exact)
{
  std::cout << title << ": " << found << ", exact to 1e-11 "
            << verdict(std::abs(found - exact) < 1e-11 * std::max(1., std::abs(exact))) << '\n';
}

void collisions()
{
  Scene scene(false, false);
  scene.add_body({{2., 1.}}, 1.);
  scene.add_body({{-1., 0.}}, 3.);
  scene.add_contact(0, 1, {{-1., 0.}}, false);
  scene.solve();
  // they go on together along the normal with the velocity of their mass centre
  print("two disks, common velocity", scene.bodies.velocity[0][0], -0.25);
  print("two disks, tangential velocity stays", scene.bodies.velocity[0][1], 1.);
  print("two disks, impulse", scene.contacts.impulse[0], 2.25);

  Scene open = scene;
  open.bodies.velocity = {{{2., 1.}}, {{-1., 0.}}};
  open.contacts.gap_velocity[0] = 1.;
  open.solve();
  print("open gap, approach left", open.bodies.velocity[0][0] - open.bodies.velocity[1][0], 1.);
  open.bodies.velocity = {{{2., 1.}}, {{-1., 0.}}};
  open.contacts.gap_velocity[0] = 4.;
  open.solve();
  print("wide gap, impulse of the start is forgotten", open.contacts.impulse[0], 0.);
}

/// Any order of the contacts gives the cradle the same velocities.
void cradle()
{
  double spread = 0.;
  std::vector<unsigned int> order = {0, 1, 2, 3};
  do
  {
    Scene scene(false, false);
    for (unsigned int i = 0; i < 5; ++i)
      scene.add_body({{i == 0 ? 5. : 0., 0.}}, 1.);
    for (const unsigned int i : order)
      scene.add_contact(i, i + 1, {{-1., 0.}}, false);
    scene.solve();
    for (const auto &v : scene.bodies.velocity)
      spread = std::max(spread, std::abs(v[0] - 1.));
  } while (std::next_permutation(order.begin(), order.end()));
  std::cout << "cradle in 24 orders, all with the velocity of the mass centre to 1e-11 "
            << verdict(spread < 1e-11) << '\n';
}

void column()
{
  constexpr unsigned int n = 10;
  Scene scene(false, false);
  for (unsigned int i = 0; i < n; ++i)
    scene.add_body({{0., -0.01}}, 2. + i);
  const std::uint32_t floor = scene.add_body({{0., 0.}}, 0.);
  for (unsigned int i = 0; i + 1 < n; ++i)
    scene.add_contact(i + 1, i, {{0., 1.}}, false);
  scene.add_contact(0, floor, {{0., 1.}}, true);
  scene.solve();
  double weight = 0., error = 0.;
  for (unsigned int i = n; i-- > 0;)
  {
    weight += 0.01 * (2. + i);
    error = std::max(error, std::abs(scene.contacts.impulse[i == 0 ? n - 1 : i - 1] - weight));
  }
  print("column, floor", scene.contacts.impulse.back(), 0.65);
  std::cout << "column, each contact carries what is above " << verdict(error < 1e-11) << '\n';
}

/// Two disks on a floor with one on top; side walls hold them, or friction does.
Scene pyramid(const double mu, const bool sides)
{
  const double s = std::sqrt(0.75);
  Scene scene(mu >= 0., false);
  for (unsigned int i = 0; i < 3; ++i)
    scene.add_body({{0., -1.}}, 1., 0.5 * Scene::radius * Scene::radius);
  for (unsigned int i = 0; i < 3; ++i)
    scene.add_body({{0., 0.}}, 0.);
  scene.add_contact(2, 0, {{0.5, s}}, false, mu);
  scene.add_contact(2, 1, {{-0.5, s}}, false, mu);
  scene.add_contact(0, 3, {{0., 1.}}, true, mu);
  scene.add_contact(1, 3, {{0., 1.}}, true, mu);
  if (sides)
  {
    scene.add_contact(0, 4, {{1., 0.}}, true, mu);
    scene.add_contact(1, 5, {{-1., 0.}}, true, mu);
  }
  scene.solve();
  return scene;
}

void pyramids()
{
  const Scene held = pyramid(-1., true);
  print("pyramid, below the top", held.contacts.impulse[0], 1. / std::sqrt(3.));
  print("pyramid, floor", held.contacts.impulse[2], 1.5);
  print("pyramid, side", held.contacts.impulse[5], 0.5 / std::sqrt(3.));
  // Without sides it stands for a friction above tan 15° = 0.2679 between the disks.
  for (const double mu : {0.267, 0.269})
    std::cout << "free pyramid, friction " << mu << ": stands "
              << verdict(std::abs(pyramid(mu, false).bodies.velocity[2][1]) < 1e-10) << '\n';
  const Scene standing = pyramid(0.4, false);
  print("free pyramid, floor", standing.contacts.impulse[2], 1.5);
  print("free pyramid, friction on the floor", std::abs(standing.contacts.tangential_impulse[2]),
        0.5 * std::tan(std::acos(-1.) / 12.));
}

/// A disk of mass 2 on an incline, g Δt = 1; @p inertia 0: a block.
Scene incline(const double slope, const double mu, const bool block, const double rolling)
{
  const double angle = std::atan(slope);
  Scene scene(true, rolling > 0.);
  scene.add_body({{std::sin(angle), -std::cos(angle)}}, 2., block ? 0. : Scene::radius * Scene::radius);
  scene.add_body({{0., 0.}}, 0.);
  scene.add_contact(0, 1, {{0., 1.}}, true, mu, rolling);
  scene.solve();
  return scene;
}

void inclines()
{
  const double mu = 0.4;
  for (const double slope : {0.399, 0.401, 1.})
  {
    const double angle = std::atan(slope);
    print("block, slope " + std::to_string(slope) + ", speed",
          incline(slope, mu, true, 0.).bodies.velocity[0][0],
          std::max(0., std::sin(angle) - mu * std::cos(angle)));
  }
  // A disk rolls with 2/3 of the acceleration while tan <= 3 mu, and slips beyond.
  for (const double slope : {1.19, 1.21})
  {
    const double angle = std::atan(slope);
    const Scene scene = incline(slope, mu, false, 0.);
    const auto &bodies = scene.bodies;
    print("disk, slope " + std::to_string(slope) + ", speed", bodies.velocity[0][0],
          slope < 1.2 ? 2. / 3. * std::sin(angle) : std::sin(angle) - mu * std::cos(angle));
    std::cout << "  rolls without slip "
              << verdict(std::abs(bodies.velocity[0][0] + Scene::radius * bodies.angular_velocity[0]) < 1e-11)
              << '\n';
  }
  // Rolling resistance l holds it while tan <= l / r; beyond, the acceleration is 2/3 (sin - l / r cos).
  for (const double slope : {0.199, 0.201, 0.5})
  {
    const double angle = std::atan(slope), length = 0.2 * Scene::radius;
    print("rolling resistance, slope " + std::to_string(slope) + ", speed",
          incline(slope, mu, false, length).bodies.velocity[0][0],
          std::max(0., 2. / 3. * (std::sin(angle) - 0.2 * std::cos(angle))));
  }
}

void errors()
{
  const auto attempt = [](const std::string &title, Scene scene)
  {
    std::cout << title << ": ";
    try
    {
      scene.solve();
      std::cout << "solved\n";
    }
    catch (const std::exception &error)
    {
      std::cout << error.what() << '\n';
    }
  };
  Scene scene(false, false);
  scene.add_body({{1., 0.}}, 1.);
  scene.add_body({{0., 0.}}, 1.);
  scene.add_contact(0, 1, {{-1., 0.}}, false);
  Scene wrong = scene;
  wrong.bodies.velocity[1][0] = std::nan("");
  attempt("velocity", wrong);
  wrong = scene;
  wrong.contacts.impulse[0] = std::nan("");
  attempt("impulse", wrong);
  wrong = scene;
  wrong.contacts.impulse.clear();
  attempt("size", wrong);
  wrong = scene;
  wrong.contacts.b[0] = 2;
  attempt("index", wrong);
  wrong = scene;
  wrong.bodies.inverse_mass = {0., 0.};
  attempt("both prescribed", wrong);
}
} // namespace

int main()
{
  collisions();
  cradle();
  column();
  pyramids();
  inclines();
  errors();
}
