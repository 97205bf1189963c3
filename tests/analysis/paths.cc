// SPDX-License-Identifier: LGPL-2.1-or-later
// Four unit disks in a square box that is squeezed to 9/10 of its height and 10/9 of its width. Three follow
// the box, one goes 0.2 m astray, which is a root mean square of 0.1 m or 0.05 diameters; one of two contacts
// is lost and two are won over |e1| + |e2| = 2 ln(10/9). Of three contacts with friction 0.5 one slides, one
// of two rows that slides belongs to a contact that sticks. A chain along y with forces that lean by
// f_t = 0.4 f_n: the tangential part makes 2 (sqrt(1 + 0.16) - 1) of anisotropy.
#include "configurations.h"

using namespace configurations;

namespace
{
Snapshot<2> box(const double width, const double height)
{
  Snapshot<2> snapshot;
  add_wall(snapshot, "bottom", {0, 0}, Vector({0., 1.}));
  add_wall(snapshot, "top", {0, height}, Vector({0., -1.}));
  add_wall(snapshot, "left", {0, 0}, Vector({1., 0.}));
  add_wall(snapshot, "right", {width, 0}, Vector({-1., 0.}));
  for (unsigned int b = 0; b < 4; ++b)
    add_ellipse(snapshot, {width * (0.25 + 0.5 * (b % 2)), height * (0.25 + 0.5 * (b / 2))}, 1, 1, 0);
  return snapshot;
}

void add_leaning(Snapshot<2> &snapshot, const unsigned int a, const unsigned int b, const double tangential)
{
  add_contact(snapshot, a, b, 1);
  ContactState<2> &contact = snapshot.contacts.back();
  contact.force += tangential * Vector({-contact.normal[1], contact.normal[0]});
}

void print_series(MeasureSeries &series, const Snapshot<2> &snapshot)
{
  for (const auto &[name, value] : series.evaluate(snapshot))
    std::cout << "  " << name << " = " << (value ? std::to_string(*value) : "none") << '\n';
}
} // namespace

int main()
{
  Snapshot<2> before = box(9, 10), after = box(10, 9);
  add_contact(before, 0, 1, 1);
  add_contact(before, 2, 3, 1);
  after.bodies[3].center[0] += 0.2;
  add_leaning(after, 0, 1, 0.5);   // slides
  add_leaning(after, 0, 2, -0.2);  // sticks
  add_leaning(after, 1, 3, 0.499); // slides in one row
  add_leaning(after, 1, 3, 0.1);   // of two
  for (const unsigned int w : {0, 1})
    after.walls[w].normal_force = 30;
  for (const unsigned int w : {2, 3})
    after.walls[w].normal_force = 9;

  MeasureSeries series({"biaxial", "rearrangements", "sliding"}, 0.5);
  std::cout << "the first\n";
  print_series(series, before);
  std::cout << "the second\n";
  print_series(series, after);

  MeasureSeries whole({"all"}, 0.5), resumed({"all"}, 0.5);
  whole.evaluate(before);
  resumed.remember(before);
  std::cout << "after a restart the same: "
            << (whole.evaluate(after) == resumed.evaluate(after) ? "yes" : "no") << '\n';

  Snapshot<2> chain = box(10, 10);
  add_leaning(chain, 0, 2, 0.4);
  add_leaning(chain, 1, 3, 0.4);
  std::cout << "leaning forces\n";
  print(chain, {"fabric"});
}
