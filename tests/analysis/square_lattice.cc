// SPDX-License-Identifier: LGPL-2.1-or-later
// Nine unit disks in a box of 6 m x 6 m, forces of 2 N/m across and 3 N/m up and down in every chain: all
// measures follow from the drawing, and are the same when contacts are cut into rows as models write them.
#include "configurations.h"

using namespace configurations;

namespace
{
void add_wall_contact(Snapshot<2> &snapshot,
                      const unsigned int body,
                      const unsigned int wall,
                      const double force)
{
  ContactState<2> contact;
  contact.body_a = body;
  contact.wall = wall;
  contact.normal = snapshot.walls[wall].normal;
  contact.place = snapshot.bodies[body].center - contact.normal;
  contact.force = force * contact.normal;
  contact.length = 0.1;
  snapshot.contacts.push_back(contact);
}

Snapshot<2> lattice()
{
  Snapshot<2> snapshot;
  add_wall(snapshot, "bottom", {0, 0}, Vector({0., 1.}));
  add_wall(snapshot, "top", {0, 6}, Vector({0., -1.}));
  add_wall(snapshot, "left", {0, 0}, Vector({1., 0.}));
  add_wall(snapshot, "right", {6, 0}, Vector({-1., 0.}));
  snapshot.walls[1].velocity = 0.3;
  for (const unsigned int w : {0, 1})
    snapshot.walls[w].normal_force = 9;
  for (const unsigned int w : {2, 3})
    snapshot.walls[w].normal_force = 6;
  for (unsigned int b = 0; b < 9; ++b)
  {
    add_ellipse(snapshot, {1. + 2 * (b % 3), 1. + 2 * (b / 3)}, 1, 1, 0);
    snapshot.bodies.back().mass *= 2;
    snapshot.bodies.back().velocity = Vector({0.1, 0.});
  }
  for (unsigned int b = 0; b < 9; ++b)
  {
    if (b % 3 < 2)
      add_contact(snapshot, b, b + 1, 2, 0.1);
    if (b < 6)
      add_contact(snapshot, b, b + 3, 3, 0.1);
  }
  for (unsigned int k = 0; k < 3; ++k)
  {
    add_wall_contact(snapshot, k, 0, 3);
    add_wall_contact(snapshot, 6 + k, 1, 3);
    add_wall_contact(snapshot, 3 * k, 2, 2);
    add_wall_contact(snapshot, 3 * k + 2, 3, 2);
  }
  snapshot.energies = {1, 2, 3, 4};
  return snapshot;
}

/// Every contact in three rows, some of them seen from the partner, and contacts inside every body.
Snapshot<2> in_rows(const Snapshot<2> &whole)
{
  Snapshot<2> snapshot = whole;
  snapshot.contacts.clear();
  for (unsigned int part = 0; part < 3; ++part)
    for (ContactState<2> row : whole.contacts)
    {
      row.force *= part == 1 ? 0.5 : 0.25;
      row.length = 0;
      const Vector tangent({-row.normal[1], row.normal[0]});
      row.place += 0.05 * (static_cast<int>(part) - 1.) * tangent;
      if (part == 2 && row.wall == ContactState<2>::not_a_body)
      {
        std::swap(row.body_a, row.body_b);
        row.normal *= -1;
        row.force *= -1;
      }
      snapshot.contacts.push_back(row);
    }
  for (unsigned int b = 0; b < 9; ++b)
  {
    ContactState<2> inside;
    inside.body_a = inside.body_b = b;
    inside.place = whole.bodies[b].center;
    inside.normal = Vector({1., 0.});
    inside.force = Vector({b % 2 == 0 ? 1e3 : -1e3, 0.});
    inside.length = 1;
    snapshot.contacts.push_back(inside);
  }
  return snapshot;
}
} // namespace

int main()
{
  const Snapshot<2> whole = lattice();
  std::cout.precision(12);
  print(whole, {"packing", "coordination", "contact_surface", "fabric", "stress", "energies", "pores"});

  const auto a = MeasureSet({"all"}).evaluate(whole), b = MeasureSet({"all"}).evaluate(in_rows(whole));
  unsigned int n_different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].second.has_value() != b[i].second.has_value() ||
        std::abs(a[i].second.value_or(0) - b[i].second.value_or(0)) > 1e-12)
    {
      ++n_different;
      std::cout << a[i].first << " differs in rows\n";
    }
  std::cout << "numbers that differ when contacts are cut into rows: " << n_different << '\n';

  // A contact of 0.4 m as primaries write it that fit into each other's gaps: seven rows of 0.1 m, one each
  // 0.05 m.
  Snapshot<2> rough;
  add_ellipse(rough, {0, 0}, 1, 1, 0);
  add_ellipse(rough, {0, 2}, 1, 1, 0);
  for (int i = -3; i <= 3; ++i)
  {
    add_contact(rough, 0, 1, 1, 0.1);
    rough.contacts.back().place[0] = 0.05 * i;
    rough.contacts.back().normal = Vector({std::sin(0.2 * i), -std::cos(0.2 * i)});
  }
  const BodyContact contact = Assembly(rough).contacts.at(0);
  std::cout << "rough contact: length " << contact.length << ", normal force " << contact.normal_force
            << '\n';

  // Without its right wall there is no box; without bodies there is nothing.
  Snapshot<2> open = whole;
  open.walls.pop_back();
  open.contacts.resize(12);
  print(open, {"packing", "stress"});
  unsigned int n_values = 0;
  for (const auto &value : MeasureSet({"all"}).evaluate(Snapshot<2>()))
    n_values += value.second.has_value() && *value.second != 0.;
  std::cout << "numbers of nothing: " << n_values << '\n';
}
