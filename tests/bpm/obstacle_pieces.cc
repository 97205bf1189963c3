// SPDX-License-Identifier: LGPL-2.1-or-later
// A line of many pieces is one obstacle: a disk thrown along it at 0.5 m/s slides until it rolls, at 2/3 of
// its speed beside that of the line. So it is on any number of pieces, mirrored, upside down, on a line that
// moves, on a closed line, over the ends of two lines that meet, and with corners that turn the other way. In
// a bowl of many pieces it swings as in an arc, and a corner that stands out is touched once. What would go
// through a line in one step is seen.
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/dynamics.h>

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
const double pi = std::acos(-1.), gravity = 9.81;

Obstacle<2> line(const Polygon &points, const double friction, const std::string &way = "0")
{
  Scene<2> scene;
  ObstacleDescription<2> description;
  description.name = "line";
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    description.pieces.push_back(Curve::segment(points[i], points[i + 1]));
  description.friction = friction;
  for (const std::string &formula : {way, std::string("0"), std::string("0")})
    description.motion.push_back(formula_of_time(formula, "line"));
  scene.obstacles = {description};
  return make_obstacles(scene)[0];
}

/// From one place to another in @p n pieces.
Polygon straight(const dealii::Point<2> &begin, const dealii::Point<2> &end, const unsigned int n)
{
  Polygon points;
  for (unsigned int i = 0; i <= n; ++i)
    points.push_back(begin + (1. * i / n) * (end - begin));
  return points;
}

class OneDisk
{
public:
  OneDisk(const dealii::Point<2> &place,
          const std::array<double, 2> &velocity,
          const double radius,
          std::vector<Obstacle<2>> list)
      : obstacles(std::move(list))
  {
    bpm::Primaries disk;
    disk.position = {{place[0], place[1]}};
    disk.velocity = {velocity};
    disk.radius = {radius};
    disk.mass = {2.};
    disk.body = {0};
    disk.angular_velocity = {0.};
    dynamics =
        std::make_unique<bpm::Dynamics>(disk, std::vector<std::shared_ptr<const bpm::Attraction>>{nullptr},
                                        std::vector<bool>{}, bpm::DynamicsSettings());
    dynamics->set_obstacles(&obstacles);
    dynamics->detect(walls);
  }

  bpm::DynamicsReport step(const double dt, const double pull = gravity)
  {
    for (Obstacle<2> &one : obstacles)
      one.plan(time, dt);
    time += dt;
    return dynamics->step(dt, walls, {{0., -pull}});
  }

  const std::array<double, 2> &place() const { return dynamics->disks().position[0]; }
  const std::array<double, 2> &velocity() const { return dynamics->disks().velocity[0]; }

  std::vector<Wall<2>> walls;
  std::vector<Obstacle<2>> obstacles;
  std::unique_ptr<bpm::Dynamics> dynamics;
  double time = 0;
};

/// Thrown at @p speed on a line, above it or below (@p side -1): speed along it at the end, and the highest
/// hop.
void slide(const std::string &what,
           std::vector<Obstacle<2>> lines,
           const double speed = 0.5,
           const double side = 1.)
{
  OneDisk disk({0., side * 0.005}, {speed, 0.}, 0.005, std::move(lines));
  double highest = 0.;
  for (unsigned int i = 0; i < 400; ++i)
  {
    disk.step(2e-4, side * gravity);
    highest = std::max(highest, side * disk.place()[1] - 0.005);
  }
  std::cout << what << ": " << disk.velocity()[0] << " m/s, hops " << (highest < 1e-9 ? "none" : "SOME")
            << '\n';
}

/// Period of a disk of 0.1 in a bowl of radius 0.5 of @p n pieces, over that of a pendulum.
double period(const unsigned int n)
{
  Polygon points;
  for (unsigned int i = 0; i <= n; ++i)
    points.push_back({0.5 * std::cos(pi + pi * i / n), 0.5 * std::sin(pi + pi * i / n)});
  const double start = 0.1, dt = 2e-4;
  OneDisk disk({0.4 * std::sin(start), -0.4 * std::cos(start)}, {0., 0.}, 0.1, {line(points, 0.)});
  std::vector<double> crossings;
  for (double before = disk.place()[0]; crossings.size() < 3; before = disk.place()[0])
  {
    disk.step(dt);
    const double now = disk.place()[0];
    if (before * now <= 0. && before != now)
      crossings.push_back(disk.time - dt * now / (now - before));
  }
  return (crossings[2] - crossings[0]) / (2. * pi * std::sqrt(0.4 / gravity) * (1. + start * start / 16.));
}
} // namespace

int main()
{
  const dealii::Point<2> left(-0.0603, 0.), right(0.0603, 0.), middle(0.0031, 0.), low(0., -0.1);
  const Polygon many = straight(left, right, 83);
  slide("one piece", {line({left, right}, 0.3)});
  slide("many pieces", {line(many, 0.3)});
  slide("drawn the other way", {line(straight(right, left, 83), 0.3)});
  slide("mirrored", {line(many, 0.3)}, -0.5);
  slide("below", {line(many, 0.3)}, 0.5, -1.);
  slide("moving by 0.2 m/s", {line(many, 0.3, "0.2*t")});
  slide("closed", {line({middle, right, low, left, middle}, 0.3)});
  slide("two lines that meet", {line({left, middle}, 0.3), line({middle, right}, 0.3)});
  slide("two lines that end in one place", {line({left, middle}, 0.3), line({right, middle}, 0.3)});

  const double swing = period(1000);
  std::cout << "period in a bowl of 1000 pieces over that of a pendulum: "
            << (std::abs(swing - 1.) < 1e-3 ? "1 within 1e-3" : std::to_string(swing)) << '\n';

  // A corner that stands out, of one line and of two; one that stands in is two contacts.
  const dealii::Point<2> a(-1., -1.), b(1., -1.), corner(0., 0.);
  for (const std::vector<Obstacle<2>> &lines :
       {std::vector<Obstacle<2>>{line({a, corner, b}, 0.)},
        std::vector<Obstacle<2>>{line({a, corner}, 0.), line({corner, b}, 0.)}})
  {
    OneDisk on({0., 0.1}, {0., 0.}, 0.1, lines), in({0., -0.1 * std::sqrt(2.)}, {0., 0.}, 0.1, lines);
    std::cout << "contacts of a corner that stands out " << on.dynamics->present().rows().size() << ", in "
              << in.dynamics->present().rows().size() << '\n';
  }

  // 20 diameters in a step, across a thin line; and the same way where nothing is.
  OneDisk bullet({0., 0.1}, {0., -200.}, 0.005, {line({left, right}, 0.)}),
      free({0.2, 0.1}, {0., -200.}, 0.005, {line({left, right}, 0.)});
  const bpm::DynamicsReport through = bullet.step(1e-3, 0.), past = free.step(1e-3, 0.);
  std::cout << "a bullet through a line: " << (through.max_penetration > 0.9 * 0.005 ? "seen" : "NOT SEEN")
            << ", past it: " << past.max_penetration << '\n';
}
