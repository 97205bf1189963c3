// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls whose impulses are known: a collision, a ball that rolls or slides down a plane, a heap of four,
// momentum and angular momentum of a cluster, its mirror image, and disks that are balls in one plane.
#include "reference.h"

#include <softgrain/base/random.h>
#include <softgrain/contact/disk_solver.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain;
using namespace softgrain::contact;

namespace
{
using Vector = std::array<double, 3>;

DiskSolverSettings exact()
{
  DiskSolverSettings settings;
  settings.tolerance = 1e-13;
  settings.wall_tolerance = 1e-12;
  settings.max_sweeps = 200000;
  return settings;
}

/// A few balls of radius 1/2 and walls; they are one tile.
struct Scene
{
  BallBodies bodies;
  BallContacts contacts;
  unsigned int n_pairs = 0;

  std::uint32_t add_body(const Vector &v, const double mass, const Vector &spin = {})
  {
    bodies.velocity.push_back(v);
    bodies.inverse_mass.push_back(mass > 0. ? 1. / mass : 0.);
    bodies.angular_velocity.push_back(spin);
    bodies.inverse_inertia.push_back(mass > 0. ? 2.5 / (mass * 0.25) : 0.);
    return bodies.size() - 1;
  }

  /// Contacts with walls have to come last.
  void add_contact(const std::uint32_t a, const std::uint32_t b, const Vector &normal, const double mu)
  {
    contacts.a.push_back(a);
    contacts.b.push_back(b);
    contacts.normal.push_back(normal);
    contacts.gap_velocity.push_back(0.);
    contacts.friction.push_back(mu);
    contacts.arm_a.push_back(0.5);
    contacts.arm_b.push_back(0.5);
    contacts.impulse.push_back(0.);
    contacts.tangential_impulse.push_back({});
    n_pairs += bodies.inverse_mass[b] > 0.;
  }

  DiskSolverReport solve()
  {
    contacts.tile_start = {0, n_pairs};
    contacts.colour_start = {0, 1};
    return solve_balls(bodies, contacts, exact());
  }
};

void print(const std::string &title, const double found, const double right, const double limit = 1e-11)
{
  std::cout << title << ": "
            << (std::abs(found - right) < limit * std::max(1., std::abs(right)) ? "as it must be"
                                                                                : std::to_string(found))
            << '\n';
}

double norm(const Vector &v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// A ball of mass 2 on a plane with this slope, towards a direction between the axes; g dt = 1.
void incline(const double mu, const double rolls)
{
  const double angle = std::atan(0.7);
  Scene scene;
  const double along = std::sin(angle);
  scene.add_body({0.6 * along, 0.8 * along, -std::cos(angle)}, 2.);
  scene.add_body({}, 0.);
  scene.add_contact(0, 1, {0., 0., 1.}, mu);
  scene.solve();
  const Vector v = scene.bodies.velocity[0], spin = scene.bodies.angular_velocity[0];
  print("velocity down the plane", norm(v), rolls > 0. ? 5. / 7. * along : along - mu * std::cos(angle));
  print("its direction", v[0] * 0.8 - v[1] * 0.6, 0.);
  print("spin", norm(spin), rolls > 0. ? norm(v) / 0.5 : 2.5 * mu * std::cos(angle) / 0.5);
  print("friction", norm(scene.contacts.tangential_impulse[0]),
        rolls > 0. ? 2. / 7. * 2. * along : mu * 2. * std::cos(angle));
}

/// Three balls that touch on a rough floor carry a fourth: each contact with it carries W / (3 cos of its
/// slope).
void heap()
{
  Scene scene;
  const double r = 1. / std::sqrt(3.), h = std::sqrt(2. / 3.);
  for (unsigned int i = 0; i < 4; ++i)
    scene.add_body({0., 0., -1.}, 1.);
  const std::uint32_t floor = scene.add_body({}, 0.);
  std::vector<Vector> place;
  for (unsigned int i = 0; i < 3; ++i)
    place.push_back({r * std::cos(2.0943951023931953 * i), r * std::sin(2.0943951023931953 * i), 0.});
  for (unsigned int i = 0; i < 3; ++i)
    scene.add_contact(3, i, {-place[i][0], -place[i][1], h}, 0.5);
  for (unsigned int i = 0; i < 3; ++i)
    scene.add_contact(i, floor, {0., 0., 1.}, 0.5);
  const DiskSolverReport report = scene.solve();
  print("heap stands", norm(scene.bodies.velocity[3]), 0., 1e-10);
  double floor_force = 0., on_top = 0.;
  for (unsigned int i = 0; i < 3; ++i)
  {
    floor_force += scene.contacts.impulse[3 + i];
    on_top += h * scene.contacts.impulse[i] + scene.contacts.tangential_impulse[i][2];
  }
  print("floor bears the weight", floor_force, 4., 1e-10);
  print("top is borne", on_top, 1., 1e-10);
  std::cout << "solved " << report.converged << '\n';
}

/// Balls at random places with contacts between neighbours, which fall towards their middle.
struct Cluster
{
  Scene scene;
  std::vector<Vector> places;

  explicit Cluster(const double mirror)
  {
    Uniform random(7);
    for (unsigned int i = 0; i < 60; ++i)
    {
      const Vector x = {mirror * 3. * random(), 3. * random(), 3. * random()};
      places.push_back(x);
      const Vector v = {mirror * (random() - 0.5) - x[0], random() - x[1], random() - x[2]};
      // A spin is no vector: in a mirror its components along the mirror change sign.
      scene.add_body(v, 0.5 + random(), {random(), mirror * random(), mirror * random()});
    }
    for (unsigned int a = 0; a < 60; ++a)
      for (unsigned int b = 0; b < a; ++b)
      {
        Vector n;
        for (unsigned int d = 0; d < 3; ++d)
          n[d] = places[a][d] - places[b][d];
        const double distance = norm(n);
        for (double &component : n)
          component /= distance;
        if (distance < 1.)
          add(a, b, n, 0.5 * distance);
      }
  }

  void add(const unsigned int a, const unsigned int b, const Vector &n, const double arm)
  {
    scene.add_contact(a, b, n, 0.4);
    scene.contacts.arm_a.back() = scene.contacts.arm_b.back() = arm;
  }

  Vector momentum() const
  {
    Vector sum{};
    for (unsigned int i = 0; i < 60; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += scene.bodies.velocity[i][d] / scene.bodies.inverse_mass[i];
    return sum;
  }
  Vector angular_momentum() const
  {
    Vector sum{};
    for (unsigned int i = 0; i < 60; ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
        const Vector &x = places[i], &v = scene.bodies.velocity[i];
        sum[d] += (x[e] * v[f] - x[f] * v[e]) / scene.bodies.inverse_mass[i] +
                  scene.bodies.angular_velocity[i][d] / scene.bodies.inverse_inertia[i];
      }
    return sum;
  }
};

void cluster()
{
  Cluster one(1.), other(-1.);
  const Vector momentum = one.momentum(), angular = one.angular_momentum();
  std::cout << "cluster solved " << one.scene.solve().converged << other.scene.solve().converged << '\n';
  double lost = 0., turned = 0., differs = 0., slide = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    lost = std::max(lost, std::abs(one.momentum()[d] - momentum[d]));
    turned = std::max(turned, std::abs(one.angular_momentum()[d] - angular[d]));
  }
  for (unsigned int i = 0; i < 60; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      differs = std::max(differs, std::abs(one.scene.bodies.velocity[i][d] -
                                           (d == 0 ? -1. : 1.) * other.scene.bodies.velocity[i][d]));
  for (std::size_t k = 0; k < one.scene.contacts.size(); ++k)
    slide =
        std::max(slide, norm(one.scene.contacts.tangential_impulse[k]) - 0.4 * one.scene.contacts.impulse[k]);
  print("momentum", lost, 0., 1e-12);
  print("angular momentum", turned, 0., 1e-12);
  print("mirror image", differs, 0.);
  print("friction within its cone", std::max(0., slide), 0.);
}

/// Disks with the inertia of balls, in one plane of space.
void plane()
{
  DiskBodies disks;
  DiskContacts contacts;
  Scene balls;
  Uniform random(3);
  for (unsigned int i = 0; i < 20; ++i)
  {
    const double vx = random(), vy = random() - 0.1 * i, spin = random();
    balls.add_body({vx, 0., vy}, 1., {0., -spin, 0.});
    disks.velocity.push_back({vx, vy});
    disks.inverse_mass.push_back(1.);
    disks.angular_velocity.push_back(spin);
    disks.inverse_inertia.push_back(10.);
  }
  for (unsigned int i = 1; i < 20; ++i)
  {
    const double angle = 0.3 * random(), sine = std::sin(angle), cosine = std::cos(angle);
    balls.add_contact(i, i - 1, {sine, 0., cosine}, 0.2);
    contacts.a.push_back(i);
    contacts.b.push_back(i - 1);
    contacts.normal.push_back({sine, cosine});
  }
  contacts.gap_velocity = contacts.impulse = contacts.tangential_impulse = std::vector<double>(19, 0.);
  contacts.friction.assign(19, 0.2);
  contacts.arm_a = contacts.arm_b = std::vector<double>(19, 0.5);
  contacts.tile_start = {0, 19};
  contacts.colour_start = {0, 1};
  solve_disks(disks, contacts, exact());
  balls.solve();
  double differs = 0.;
  for (unsigned int i = 0; i < 20; ++i)
    differs = std::max({differs, std::abs(balls.bodies.velocity[i][0] - disks.velocity[i][0]),
                        std::abs(balls.bodies.velocity[i][2] - disks.velocity[i][1]),
                        std::abs(balls.bodies.velocity[i][1]),
                        std::abs(balls.bodies.angular_velocity[i][1] + disks.angular_velocity[i])});
  print("disks are balls in a plane", differs, 0.);
}
} // namespace

int main()
{
  Scene two;
  two.add_body({2., 1., 0.5}, 1.);
  two.add_body({-1., 0., 0.}, 3.);
  two.add_contact(0, 1, {-1., 0., 0.}, 0.);
  two.solve();
  print("two balls, common velocity", two.bodies.velocity[0][0], -0.25);
  print("two balls, velocity across stays", two.bodies.velocity[0][2], 0.5);
  print("two balls, impulse", two.contacts.impulse[0], 2.25);
  incline(0.5, 1.);
  incline(0.1, 0.);
  heap();
  cluster();
  plane();
}
