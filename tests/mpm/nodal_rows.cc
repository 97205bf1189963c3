// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows at shared nodes, known by counting: rectangles whose edges lie on the lattice touch along six nodes,
// their normal is that of the edge, the gap is the distance of the edges, however dense they are inside;
// three bodies at one node have a row for every pair.
#include <softgrain/base/registry.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/contact/nodal_contact.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <set>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
/// A row of rectangles on a lattice of cells of 0.1 m.
class Setup
{
public:
  Setup()
      : lattice(dealii::Point<2>(0., 0.), dealii::Point<2>(2., 2.), 0.1)
      , points(lattice, PointLayout<2>(needs()))
      , shape(create_shape_function("linear"))
  {
    points.cover_all();
  }

  void add(const double left, const double bottom, const double right, const double top)
  {
    BodyDescription<2> description;
    description.name = std::string(1, static_cast<char>('a' + bodies.size()));
    description.center = dealii::Point<2>(0.5 * (left + right), 0.5 * (bottom + top));
    description.shape =
        std::make_shared<Rectangle2D>(description.center, dealii::Tensor<1, 2>({right - left, top - bottom}));
    const BuildContext context{lattice, *shape, settings, points};
    bodies.push_back(make_body(description, bodies.size(),
                               Registry<constitutive::Law<2>>::instance().create("linear_elastic"), 1000.,
                               context));
    fill_body(bodies.back(), description, context);
    points.sort();
    const auto lists = points.by_body(PointStore<2>::LevelsOfBodies(bodies.size(), nullptr));
    for (Body<2> &body : bodies)
      body.points.renew(points.handler().get_property_pool(), lists[body.index]);
    start_body(bodies.back(), description, context);
  }

  /// Makes the first body lighter left of @p x, and the more so the lower: density that a blow from the right
  /// has left.
  void make_lighter(const double x)
  {
    for (unsigned int p = 0; p < bodies[0].points.size(); ++p)
    {
      auto point = bodies[0].points[p];
      if (point.position()[0] < x)
        point.mass() *= 0.75 + 1.5 * (point.position()[1] - 0.75);
    }
  }

  std::vector<ContactRow<2>> find(const bool gap) const
  {
    std::vector<ContactRow<2>> rows;
    const ContactPairs between = pairs();
    NodalContact(*shape, gap).find({bodies, walls, between, 1e-6, 0.1}, rows);
    return rows;
  }

  std::vector<WallMotion<2>> walls;

private:
  /// Friction of 0.3 between bodies and 0.2 with walls.
  ContactPairs pairs() const
  {
    Scene<2> scene;
    scene.materials.resize(1);
    scene.bodies.resize(bodies.size());
    scene.friction = 0.3;
    scene.walls.resize(walls.size());
    for (WallDescription<2> &wall : scene.walls)
      wall.friction = 0.2;
    return ContactPairs(scene);
  }

  static PointNeeds needs()
  {
    PointNeeds needs;
    needs.volume = true; // as the law of add() asks
    needs.n_history = Registry<constitutive::Law<2>>::instance().create("linear_elastic")->n_history();
    return needs;
  }

  Lattice<2> lattice;
  PointStore<2> points;
  std::unique_ptr<ShapeFunction> shape;
  Settings settings;
  std::vector<Body<2>> bodies;
};

/// Number of rows, and of those away from the corners the common normal and gap; at a corner a gradient
/// depends on how much of the cell is filled.
void print(const std::string &what, std::vector<ContactRow<2>> rows)
{
  std::cout << what << ": rows " << rows.size();
  if (rows.empty())
  {
    std::cout << '\n';
    return;
  }
  double spread = 0.;
  std::set<std::uint64_t> keys;
  for (const ContactRow<2> &row : rows)
    keys.insert(row.key);
  const bool different = keys.size() == rows.size();
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const auto &row) { return std::abs(row.place[1] - 0.75) > 0.2; }),
             rows.end());
  for (const ContactRow<2> &row : rows)
  {
    const auto sum = [](const NodeWeights &w)
    { return std::accumulate(w.weight.begin(), w.weight.end(), 0.); };
    spread = std::max({spread, (row.normal - rows[0].normal).norm(), std::abs(row.gap - rows[0].gap),
                       std::abs(sum(*row.weights.body) - 1.)});
    if (row.partner != ContactRow<2>::none)
      spread = std::max(spread, std::abs(sum(*row.weights.partner) - 1.));
  }
  const auto near_zero = [](const double x) { return std::abs(x) < 1e-12 ? 0. : x; };
  std::cout << ", normal " << near_zero(rows[0].normal[0]) << ' ' << near_zero(rows[0].normal[1]) << ", gap "
            << near_zero(rows[0].gap) << ", friction " << rows[0].law.friction << ", all alike "
            << (spread < 1e-12 ? "yes" : "no") << ", keys differ " << (different ? "yes" : "no") << '\n';
}
} // namespace

int main()
{
  const auto pair = [](const double gap, const bool with_gap, const bool uneven = false)
  {
    Setup setup;
    setup.add(0.4, 0.5, 1.0, 1.0);
    setup.add(1.0 + gap, 0.5, 1.6 + gap, 1.0);
    if (uneven)
      setup.make_lighter(0.9);
    return setup.find(with_gap);
  };
  print("edge to edge", pair(0., true));
  print("half a cell apart", pair(0.05, true));
  print("half a cell apart, no gap", pair(0.05, false));
  print("a cell apart", pair(0.1, true));
  print("half a cell inside", pair(-0.05, true));
  print("the same, denser where they meet", pair(-0.05, true, true));

  Setup wall;
  wall.add(0.5, 0.5, 1.0, 1.0);
  wall.walls.push_back({dealii::Point<2>(0.45, 0.), dealii::Tensor<1, 2>({1., 0.}), 0.});
  print("plane wall half a cell behind", wall.find(true));
  print("the same, no gap", wall.find(false));
  wall.walls[0].plane = false;
  print("a wall that is a body makes no rows of its own", wall.find(true));

  Setup three;
  three.add(0.5, 0.5, 1.0, 1.0);
  three.add(1.0, 0.5, 1.5, 1.0);
  three.add(0.5, 1.0, 1.5, 1.5);
  std::cout << "three bodies, rows at the common node:\n";
  for (const ContactRow<2> &row : three.find(true))
    if (row.place.distance(dealii::Point<2>(1., 1.)) < 1e-9)
      std::cout << "  " << row.body << ' ' << row.partner << ", slope of the normal "
                << (std::abs(row.normal[1]) < 1e-12 ? 0. : row.normal[1] / row.normal[0]) << '\n';
}
