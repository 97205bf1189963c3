// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_analysis_configurations_h
#define softgrain_tests_analysis_configurations_h

// Snapshots put together by hand, and their measures in print.
#include <softgrain/analysis/measure.h>

#include <cmath>
#include <iostream>

namespace configurations
{
using namespace softgrain;
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;

/// A body of unit density with this outline, at rest.
inline void add_body(Snapshot<2> &snapshot,
                     const Point &center,
                     const std::vector<std::vector<Point>> &outline,
                     const double area)
{
  BodyState<2> body;
  body.name = std::to_string(snapshot.bodies.size());
  body.center = center;
  body.outline = outline;
  body.area = body.reference_area = body.mass = area;
  snapshot.bodies.push_back(body);
}

/// A body whose outline is the ellipse with half axes @p a and @p b, @p a at @p angle.
inline void
add_ellipse(Snapshot<2> &snapshot, const Point &center, const double a, const double b, const double angle)
{
  std::vector<Point> ring;
  for (unsigned int i = 0; i < 400; ++i)
  {
    const double x = a * std::cos(M_PI * i / 200), y = b * std::sin(M_PI * i / 200);
    ring.push_back(center + Vector({std::cos(angle) * x - std::sin(angle) * y,
                                    std::sin(angle) * x + std::cos(angle) * y}));
  }
  add_body(snapshot, center, {ring}, M_PI * a * b);
}

/// Adds a contact of two bodies at half the way between them: @p force presses, @p length long.
inline void add_contact(Snapshot<2> &snapshot,
                        const unsigned int a,
                        const unsigned int b,
                        const double force,
                        const double length = 0)
{
  ContactState<2> contact;
  contact.body_a = a;
  contact.body_b = b;
  const Vector branch = snapshot.bodies[a].center - snapshot.bodies[b].center;
  contact.place = snapshot.bodies[b].center + 0.5 * branch;
  contact.normal = branch / branch.norm();
  contact.force = force * contact.normal;
  contact.length = length;
  snapshot.contacts.push_back(contact);
}

inline void add_wall(Snapshot<2> &snapshot, const std::string &name, const Point &point, const Vector &normal)
{
  WallState<2> wall;
  wall.name = name;
  wall.point = point;
  wall.normal = normal;
  snapshot.walls.push_back(wall);
}

/// Prints the numbers of these measures, a line for each.
inline void print(const Snapshot<2> &snapshot, const std::vector<std::string> &names)
{
  for (const auto &[name, value] : MeasureSet(names).evaluate(snapshot))
  {
    std::cout << "  " << name << " = ";
    if (value)
      // Zeros are written as such, so that rounding is not compared.
      std::cout << (std::abs(*value) < 1e-14 ? 0. : *value) << '\n';
    else
      std::cout << "none\n";
  }
}
} // namespace configurations

#endif
