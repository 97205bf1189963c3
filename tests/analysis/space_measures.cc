// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures in space of eight balls on a cubic lattice in a box: with forces along the axes all of them are
// known.
#include <softgrain/analysis/measure.h>
#include <softgrain/geometry/solid.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
constexpr double R = 0.5;
constexpr unsigned int none = ContactState<3>::not_a_body;

/// Eight balls of diameter 1 that touch each other and the six walls of a box with edges 2; every contact
/// along an axis carries that axis' force in two rows.
Snapshot<3> lattice(const dealii::Tensor<1, 3> &force)
{
  Snapshot<3> snapshot;
  const auto side = [](const unsigned int b, const unsigned int d) { return (b >> d) & 1; };
  for (unsigned int b = 0; b < 8; ++b)
  {
    BodyState<3> body;
    body.name = "ball";
    // An ellipsoid with the semi-axes .5, .4 and .25, the longest along z or, of every fourth, along x.
    const TriangulatedSurface surface = Sphere(dealii::Point<3>(), 0.5).surface(0.1);
    body.triangles = surface.triangles;
    body.outline.emplace_back();
    for (const dealii::Point<3> &x : surface.vertices)
      body.outline[0].push_back(b % 4 == 0 ? dealii::Point<3>(x[0], 0.5 * x[1], 0.8 * x[2])
                                           : dealii::Point<3>(0.5 * x[0], 0.8 * x[1], x[2]));
    body.area = body.reference_area = 4. / 3. * M_PI * R * R * R;
    body.mass = 1000. * body.area;
    body.velocity[0] = 2.;
    body.center = dealii::Point<3>(R + side(b, 0), R + side(b, 1), R + side(b, 2));
    snapshot.bodies.push_back(body);
  }
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int upper = 0; upper < 2; ++upper)
    {
      WallState<3> wall;
      wall.name = Box<3>::sides[2 * d + upper];
      wall.normal[d] = upper ? -1. : 1.;
      wall.point[d] = 2. * upper;
      wall.velocity = d == 2 ? 0.02 : 0.;
      wall.normal_force = 4. * force[d];
      snapshot.walls.push_back(wall);
    }
  const auto add = [&](ContactState<3> contact, const unsigned int d, const double sign)
  {
    contact.normal[d] = sign;
    contact.force = 0.5 * force[d] * contact.normal;
    for (const double beside : {-0.1, 0.1})
    {
      contact.place = snapshot.bodies[contact.body_a].center - R * contact.normal;
      contact.place[(d + 1) % 3] += beside;
      snapshot.contacts.push_back(contact);
    }
  };
  for (unsigned int b = 0; b < 8; ++b)
    for (unsigned int d = 0; d < 3; ++d)
    {
      ContactState<3> contact;
      contact.body_a = b;
      contact.wall = 2 * d + side(b, d);
      add(contact, d, side(b, d) ? -1. : 1.);
      if (side(b, d))
        continue;
      contact.wall = none;
      contact.body_b = b + (1 << d);
      // Told from either side.
      if (d == 1)
        std::swap(contact.body_a, contact.body_b);
      add(contact, d, d == 1 ? 1. : -1.);
    }
  return snapshot;
}

void print(const char *title, const Snapshot<3> &snapshot)
{
  std::cout << title << '\n';
  for (const auto &[name, value] : MeasureSetIn<3>({"all"}).evaluate(snapshot))
    if (name.find("force_") != 0)
    {
      std::cout << "  " << name << ' ';
      if (value)
        std::cout << (std::abs(*value) < 1e-12 ? 0. : *value) << '\n';
      else
        std::cout << "-\n";
    }
}
/// The box halves its height and doubles its width; the bodies follow but for the last, which goes its own
/// way by a diameter along x and loses a contact.
void moved()
{
  const Snapshot<3> before = lattice(dealii::Tensor<1, 3>({1., 1., 1.}));
  Snapshot<3> now = before;
  for (BodyState<3> &body : now.bodies)
  {
    body.center[0] *= 2.;
    body.center[2] = 0.5 * body.center[2] + 1.; // the bottom comes up
  }
  now.bodies.back().center[0] += 1.;
  now.walls[1].point[0] = 4.;
  now.walls[4].point[2] = 1.;
  const auto last = [](const ContactState<3> &contact) { return contact.body_a == 6 && contact.body_b == 7; };
  now.contacts.erase(std::remove_if(now.contacts.begin(), now.contacts.end(), last), now.contacts.end());
  MeasureSeriesIn<3> series({"rearrangements"}, 0.);
  for (const Snapshot<3> &snapshot : {before, now})
    for (const auto &[name, value] : series.evaluate(snapshot))
      std::cout << "  " << name << ' ' << (value ? std::to_string(*value) : "-") << '\n';
}
} // namespace

int main()
{
  // Pressure 1 Pa from all sides: 4 N on 4 m^2.
  print("pressed alike", lattice(dealii::Tensor<1, 3>({1., 1., 1.})));
  // Stresses 1, 2 and 6: p = 3, q = (21)^(1/2).
  print("pressed by 1, 2 and 6", lattice(dealii::Tensor<1, 3>({1., 2., 6.})));
  Snapshot<3> columns = lattice(dealii::Tensor<1, 3>({0., 0., 1.}));
  std::vector<ContactState<3>> along_z;
  for (const ContactState<3> &contact : columns.contacts)
    if (contact.force.norm() > 0.)
      along_z.push_back(contact);
  columns.contacts = along_z;
  columns.contacts.pop_back(); // of the last wall: its ball and the one below hang on nothing more
  columns.contacts.pop_back();
  columns.walls.back().name = "lid";
  moved();
  print("columns, one without its end, no box", columns);
}
