// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact rows are the derivatives of gaps: of two disks that have been deformed until their outlines cross,
// one is moved, turned, strained and waved by very little, and the change of every gap is compared with what
// the rows say. Rows that do not count that their places slide along the outline miss a part of it. Last, one
// disk is dented where it faces the other, and its sides touch: they are found as by a search at all markers.
// The rate of a gap that a row tells does not jump while its place passes a marker, also where markers are
// not equally far apart.
// Two that are flattened side by side do not touch: the far side of one is not in contact with that of the
// other.
#include <softgrain/base/registry.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/contact/contact_system.h>
#include <softgrain/mpm/contact/surface_contact.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
using Vectors = std::vector<Eigen::VectorXd>;
using Vector = dealii::Tensor<1, 2>;

constexpr double radius = 0.5, cell = 0.17;

/// Two disks side by side.
class Pair
{
public:
  Pair()
      : lattice(dealii::Point<2>(0., 0.), dealii::Point<2>(2.6, 1.6), cell)
      , points(lattice, PointLayout<2>(needs()))
      , shape(create_shape_function("linear"))
      , drive(2)
  {
    points.cover_all();
    add({0.73, 0.80});
    add({1.72, 0.87});
    scene.materials.resize(1);
    scene.bodies.resize(2);
  }

  /// The displacements u(number of the body, arm from its centre) of the nodes.
  template <class Field>
  Vectors displacements(const Field &field) const
  {
    Vectors all;
    for (const Body<2> &body : bodies)
    {
      Eigen::VectorXd u(body.field.n_dofs());
      for (unsigned int i = 0; i < body.mass.size(); ++i)
      {
        const Vector value =
            field(body.index, body.field.position(body.field.node_of_independent(i)) - centers[body.index]);
        u[2 * i] = value[0];
        u[2 * i + 1] = value[1];
      }
      all.push_back(u);
    }
    return all;
  }

  std::vector<ContactRow<2>> rows(const Vectors &u, const bool slide) const
  {
    const ContactPairs pairs(scene);
    ContactScene<2> where{bodies, drive, walls, pairs, 1., cell, &u, 1., true, slide};
    std::vector<ContactRow<2>> found;
    SurfaceContact().find(where, found);
    return found;
  }

  /// The largest error of a row in a change @p v, over the largest change of a gap, where they overlap.
  double error(const Vectors &u, const Vectors &v, const bool slide) const
  {
    constexpr double little = 1e-6;
    ContactSystem<2> system;
    system.reinit(rows(u, slide), BodyShare(), false, bodies, 1., nullptr);
    const std::vector<double> said = system.relative_velocity(BodyShare(), bodies, drive, v);
    std::map<std::uint64_t, double> change;
    for (const double side : {1., -1.})
    {
      Vectors moved = u;
      for (unsigned int b = 0; b < moved.size(); ++b)
        moved[b] += side * little * v[b];
      for (const ContactRow<2> &row : rows(moved, slide))
        change[row.key] += 0.5 * side / little * row.gap_where_found;
    }
    double worst = 0., largest = 0.;
    for (unsigned int r = 0; r < said.size(); ++r)
    {
      const ContactRow<2> &row = system.contact_rows()[r];
      if (row.gap_where_found > 0.)
        continue;
      worst = std::max(worst, std::abs(change.at(row.key) - said[r]));
      largest = std::max(largest, std::abs(change.at(row.key)));
    }
    return worst / largest;
  }

  /// The disk on the left goes up by @p way in this many steps. Of all rows that overlap: the largest
  /// difference, from one step to the next, of the rate of a gap that a row tells for velocities @p v, over
  /// the largest such rate.
  double jump(const Vectors &u, const Vectors &v, const double way, const unsigned int steps) const
  {
    std::map<std::uint64_t, double> before;
    double worst = 0., largest = 0.;
    for (unsigned int step = 0; step <= steps; ++step)
    {
      Vectors moved = u;
      for (unsigned int i = 1; i < moved[0].size(); i += 2)
        moved[0][i] += step * way / steps;
      ContactSystem<2> system;
      system.reinit(rows(moved, true), BodyShare(), false, bodies, 1., nullptr);
      const std::vector<double> said = system.relative_velocity(BodyShare(), bodies, drive, v);
      std::map<std::uint64_t, double> now;
      for (unsigned int r = 0; r < said.size(); ++r)
        if (system.contact_rows()[r].gap_where_found < 0.)
        {
          const std::uint64_t key = system.contact_rows()[r].key;
          now[key] = said[r];
          largest = std::max(largest, std::abs(said[r]));
          if (before.count(key) > 0)
            worst = std::max(worst, std::abs(said[r] - before[key]));
        }
      before = now;
    }
    return worst / largest;
  }

  /// The disk on the left gets a dent on the right, deeper than the search looks, and bulges beside it.
  void dent()
  {
    Body<2> &body = bodies[0];
    for (dealii::Point<2> &x : body.boundary.position)
    {
      const Vector arm = x - centers[0];
      if (arm[0] > 0.)
        x[0] += 2.4 * arm[1] * arm[1] - 0.2 * std::exp(-100. * arm[1] * arm[1]);
    }
  }

  /// The disk on the left is stretched along its right side.
  void stretch(const double by)
  {
    for (dealii::Point<2> &x : bodies[0].boundary.position)
      x[1] = centers[0][1] + by * (x[1] - centers[0][1]);
  }

  /// The largest distance between neighbouring markers of it that look, where the two are near [cells].
  double spacing() const
  {
    const ContactPairs pairs(scene);
    std::vector<ContactRow<2>> found;
    SurfaceContact().find({bodies, drive, walls, pairs, 1., cell, nullptr, 0., false, false}, found);
    std::vector<double> heights;
    for (const ContactRow<2> &row : found)
      heights.push_back(row.place[1]);
    std::sort(heights.begin(), heights.end());
    double widest = 0.;
    for (unsigned int r = 1; r < heights.size(); ++r)
      widest = std::max(widest, heights[r] - heights[r - 1]);
    return widest / cell;
  }

  /// The largest overlap of the two at rest that rows know [m]. @param free whether places stand in space
  double overlap(const bool free) const
  {
    const ContactPairs pairs(scene);
    std::vector<ContactRow<2>> found;
    SurfaceContact().find({bodies, drive, walls, pairs, 1., cell, nullptr, 0., free, false}, found);
    double deepest = 0.;
    for (const ContactRow<2> &row : found)
      deepest = std::max(deepest, -row.gap_where_found);
    return deepest;
  }

private:
  static std::unique_ptr<constitutive::Law<2>> law()
  {
    return Registry<constitutive::Law<2>>::instance().create("linear_elastic");
  }

  static PointNeeds needs()
  {
    PointNeeds needs;
    needs.volume = true;
    needs.n_history = law()->n_history();
    return needs;
  }

  void add(const dealii::Point<2> &center)
  {
    BodyDescription<2> description;
    description.name = std::string(1, static_cast<char>('a' + bodies.size()));
    description.center = center;
    description.shape = std::make_shared<Disk2D>(center, radius);
    const BuildContext context{lattice, *shape, settings, points};
    bodies.push_back(make_body(description, bodies.size(), law(), 1000., context));
    fill_body(bodies.back(), description, context);
    points.sort();
    const auto lists = points.by_body(PointStore<2>::LevelsOfBodies(bodies.size(), nullptr));
    for (Body<2> &body : bodies)
      body.points.renew(points.handler().get_property_pool(), lists[body.index]);
    start_body(bodies.back(), description, context);
    centers.push_back(center);
  }

  Lattice<2> lattice;
  PointStore<2> points;
  std::unique_ptr<ShapeFunction> shape;
  Settings settings;
  Scene<2> scene;
  std::vector<Body<2>> bodies;
  std::vector<dealii::Point<2>> centers;
  std::vector<Vector> drive;
  std::vector<WallMotion<2>> walls;
};
} // namespace

int main()
{
  Pair pair;
  // Flattened towards each other, and bent.
  const Vectors pressed = pair.displacements(
      [](const unsigned int b, const Vector &x)
      {
        const double side = b == 0 ? 1. : -1., out = side * x[0] / radius;
        return Vector({side * (0.06 - 0.05 * out * out * out), 0.04 * x[1] * out + 0.03 * x[0] * x[0]});
      });
  const auto one = [&](const auto &field)
  {
    return pair.displacements([&](const unsigned int b, const Vector &x)
                              { return b == 0 ? field(x) : Vector(); });
  };
  const std::pair<const char *, Vectors> changes[] = {
      {"moved across", one(
                           [](const Vector &) {
                             return Vector({0., 1.});
                           })},
      {"turned", one(
                     [](const Vector &x) {
                       return Vector({-x[1], x[0]});
                     })},
      {"strained", one(
                       [](const Vector &x) {
                         return Vector({x[0], -x[1]});
                       })},
      {"waved", one(
                    [](const Vector &x) {
                      return Vector({std::sin(4. * x[1]), std::cos(3. * x[0])});
                    })}};
  for (const auto &[name, change] : changes)
    std::cout << name << ": error " << pair.error(pressed, change, true) << ", places taken to stay "
              << pair.error(pressed, change, false) << '\n';
  const Vectors squeezed = pair.displacements(
      [](const unsigned int b, const Vector &x)
      {
        const double side = b == 0 ? 1. : -1., out = side * x[0] / radius;
        return Vector({side * (0.06 - 0.05 * out * out * out), 0.3 * std::sin(12. * x[1]) / 12.});
      });
  std::cout << "passing markers, in 400 steps: largest jump of a row "
            << pair.jump(squeezed, changes[1].second, 0.1, 400) << '\n';
  const Vectors thin = pair.displacements(
      [](const unsigned int b, const Vector &x) {
        return Vector({(b == 0 ? 0.305 : -0.305) - 0.65 * x[0], 0.});
      });
  double apart = 1.;
  for (const ContactRow<2> &row : pair.rows(thin, false))
    apart = std::min(apart, row.gap_where_found);
  std::cout << "flattened, beside each other: least gap " << apart << '\n';
  for (const double by : {1., 2., 3.})
  {
    pair.stretch(by);
    std::cout << "stretched " << by << " times: markers that look are up to " << pair.spacing()
              << " cells apart\n";
    pair.stretch(1. / by);
  }
  pair.dent();
  std::cout << "touching beside their centres: overlap " << pair.overlap(true) << ", by all markers "
            << pair.overlap(false) << '\n';
}
