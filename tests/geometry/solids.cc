// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes in space: places lie on the surface, normals and bends are those of differences, supports and
// volumes those of fine triangles, depths below distances, and what touches does not overlap.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/box_solid.h>
#include <softgrain/geometry/cylinder_solid.h>
#include <softgrain/geometry/polyhedron.h>
#include <softgrain/geometry/star_solid.h>
#include <softgrain/geometry/superellipsoid.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

using namespace softgrain;
using Point = dealii::Point<3>;
using Vector = dealii::Tensor<1, 3>;

namespace
{
std::string below(const double limit, const double value)
{
  return value < limit ? "small" : std::to_string(value) + " is not below " + std::to_string(limit);
}

/// By how much a little way along the tangents leads beside where place() says, over the cube of the way.
double beside_second_order(const Shape<3> &shape)
{
  double most = 0.;
  for (const Point &x : shape.surface(0.7).vertices)
  {
    const SurfacePlace<3> here = shape.place(x);
    for (const double angle : {0.3, 1.4, 2.5})
    {
      constexpr double way = 1e-3;
      const dealii::Tensor<1, 2> a({way * std::cos(angle), way * std::sin(angle)});
      const Point told = here.position + a[0] * here.tangent[0] + a[1] * here.tangent[1] -
                         0.5 * (a * (here.bend * a)) * here.normal;
      // The place that stands over the told one along the normal.
      Point at = told;
      double low = -1e-4, high = 1e-4;
      for (unsigned int halving = 0; halving < 60; ++halving)
      {
        const double middle = 0.5 * (low + high);
        at = told + middle * here.normal;
        (shape.depth(at) > 0. ? low : high) = middle;
      }
      most = std::max(most, std::abs(0.5 * (low + high)) / (way * way * way));
    }
  }
  return most;
}

double volume_of(const TriangulatedSurface &surface)
{
  double sum = 0.;
  for (const auto &[a, b, c] : surface.triangles)
  {
    const Vector x(surface.vertices[a]), y(surface.vertices[b]), z(surface.vertices[c]);
    sum += x * dealii::cross_product_3d(y, z) / 6.;
  }
  return sum;
}

void look_at(const std::string &name, const Shape<3> &shape)
{
  std::cout << name << ":\n  a way of 1e-3 is told to third order, with a factor "
            << (beside_second_order(shape) < 20. ? "below 20" : "above 20") << '\n';
  const TriangulatedSurface fine = shape.surface(0.04);
  std::cout << "  volume of triangles over that told " << std::fixed << std::setprecision(3)
            << volume_of(fine) / shape.volume() << '\n';
  double off_normal = 0., off_surface = 0., beyond = 0.;
  for (const Vector &direction : {Vector({1., 0., 0.}), Vector({0.3, -0.5, 0.8}), Vector({-0.2, 0.9, 0.1})})
  {
    const Vector n = direction / direction.norm();
    const auto [least, greatest] = shape.distances_from_plane(Point(0.1, 0.2, 0.3), n);
    double low = 1e9, high = -1e9;
    for (const Point &x : fine.vertices)
    {
      low = std::min(low, (x - Point(0.1, 0.2, 0.3)) * n);
      high = std::max(high, (x - Point(0.1, 0.2, 0.3)) * n);
    }
    beyond = std::max({beyond, std::abs(low - least), std::abs(high - greatest)});
  }
  unsigned int too_deep = 0, wrong_side = 0;
  for (const Point &x : shape.surface(0.5).vertices)
  {
    const SurfacePlace<3> place = shape.place(x);
    off_surface = std::max(off_surface, std::abs(shape.depth(place.position)));
    off_normal = std::max(off_normal, std::abs(place.normal.norm() - 1.));
    for (const double d : {-0.4, -0.05, 0.05, 0.3})
    {
      const double depth = shape.depth(place.position - d * place.normal);
      too_deep += std::abs(depth) > (1. + 1e-12) * std::abs(d);
      wrong_side += depth * d <= 0.;
    }
  }
  std::cout << "  places off the surface: " << below(1e-12, off_surface)
            << ", normals that are not unit: " << below(1e-12, off_normal) << '\n'
            << "  support beyond the triangles: " << below(4e-3, beyond) << '\n'
            << "  depths beyond distances: " << too_deep << ", on the wrong side: " << wrong_side << '\n';
  unsigned int missed = 0;
  const auto [lower, upper] = shape.bounding_box();
  for (const Point &x : fine.vertices)
  {
    // A box about a place of the surface is gone through by it.
    const Vector half({0.11, 0.07, 0.09});
    const auto found = shape.surface_in_box(x - half, x + half);
    missed += !found || std::abs(shape.depth(*found)) > 1e-10;
  }
  missed += shape.surface_in_box(upper + Vector({1., 1., 1.}), upper + Vector({2., 2., 2.})).has_value();
  std::cout << "  boxes of the surface that are missed: " << missed << '\n';
}

/// By how much volumes, places, normals and curvatures of two differ.
double apart(const Shape<3> &one, const Shape<3> &other)
{
  double off = std::abs(one.volume() - other.volume());
  for (const Point &x : one.surface(0.3).vertices)
  {
    const SurfacePlace<3> a = one.place(x), b = other.place(x);
    off = std::max({off, a.position.distance(b.position), (a.normal - b.normal).norm(),
                    (a.bend - b.bend).norm(), std::abs(one.depth(x) - other.depth(x))});
  }
  return off;
}

/// With a dent in one side.
TriangulatedSurface bent(TriangulatedSurface surface)
{
  for (Point &x : surface.vertices)
    x[2] += 0.25 * x[0] * x[0];
  return surface;
}

void check_hull(const std::string &name, const std::vector<Vector> &points)
{
  std::vector<Point> places;
  for (const Vector &x : points)
    places.emplace_back(x);
  const ConvexHull hull(places);
  std::cout << name << " has " << hull.corners.size() << " corners, " << hull.edges.size() << " edges and "
            << hull.faces.size() << " faces, volume " << std::setprecision(3) << hull.volume() << ", area "
            << hull.area() << '\n';
}
} // namespace

int main()
{
  const Point center(0.2, -0.1, 0.4);
  const Vector turn({0.4, -0.7, 0.2});
  look_at("sphere", Sphere(center, 1.3));
  look_at("ellipsoid", Superellipsoid(center, Vector({1.5, 1.1, 0.8}), {{2., 2.}}, turn));
  look_at("superellipsoid", Superellipsoid(center, Vector({1.2, 1.1, 0.9}), {{4., 3.}}, turn));
  look_at("cylinder", Superellipsoid(center, Vector({1., 1., 1.2}), {{6., 2.}}, turn));
  const std::vector<Vector> cube = {Vector({1., 1., 1.}),   Vector({-1., 1., 1.}),   Vector({1., -1., 1.}),
                                    Vector({1., 1., -1.}),  Vector({-1., -1., 1.}),  Vector({-1., 1., -1.}),
                                    Vector({1., -1., -1.}), Vector({-1., -1., -1.}), Vector({0., 0.2, 1.}),
                                    Vector({0.1, 0.3, 0.})};
  look_at("cube", Polyhedron(center, cube, 0.4, turn));
  look_at("tetrahedron", Polyhedron(center, {cube[0], cube[4], cube[5], cube[6]}, 0.3, turn));
  look_at("plate", Polyhedron(center, {cube[0], cube[1], cube[2], cube[4]}, 0.4, turn));
  look_at("rod", Polyhedron(center, {cube[0], cube[7], Vector()}, 0.6, turn));
  look_at("box", BoxSolid(center, Vector({2.8, 2., 1.6}), 0.4, turn));
  look_at("tablet", CylinderSolid(center, 1.4, 1.3, 0.3, turn));
  look_at("cylinder with hemispheres", CylinderSolid(center, 0.7, 3., 0.7, turn));
  const Superellipsoid bean(Point(), Vector({1.5, 1.1, 0.8}), {{4., 3.}}, turn);
  look_at("a surface of triangles", StarSolid(center, bent(bean.surface(0.2)), 12, turn));
  check_hull("cube", cube);
  check_hull("plate", {cube[0], cube[1], cube[2], cube[4], Vector({1., 0., 1.})});
  check_hull("rod", {cube[0], Vector(), cube[7]});

  const Sphere ball(center, 1.3);
  const Superellipsoid round(center, Vector({1.3, 1.3, 1.3}), {{2., 2.}}, turn);
  const Polyhedron point(center, {Vector()}, 1.3, turn);
  const CylinderSolid low(center, 1.3, 2.6, 1.3, turn);
  std::cout << "a ball is another one as an ellipsoid by " << below(1e-12, apart(ball, round))
            << ", as a polyhedron by " << below(1e-12, apart(ball, point)) << ", as a cylinder by "
            << below(1e-12, apart(ball, low)) << '\n'
            << "a cube is another one as a box by "
            << below(1e-12, apart(Polyhedron(center, {cube.begin(), cube.begin() + 8}, 0.4, turn),
                                  BoxSolid(center, Vector({2.8, 2.8, 2.8}), 0.4, turn)))
            << ", a rod as a cylinder by "
            << below(1e-12,
                     apart(Polyhedron(center, {Vector({0., 0., 1.}), Vector({0., 0., -1.})}, 0.6, turn),
                           CylinderSolid(center, 0.6, 3.2, 0.6, turn)))
            << '\n';

  // A ball of triangles is nearly one, also where their corners run the other way.
  TriangulatedSurface triangles = ball.surface(0.1);
  const StarSolid told(center, triangles, 8, turn);
  for (auto &t : triangles.triangles)
    std::swap(t[0], t[1]);
  const StarSolid inverted(center, triangles, 8, turn);
  double uneven = 0., other_way = 0.;
  for (const Point &x : ball.surface(0.4).vertices)
  {
    uneven = std::max(uneven, std::abs(told.place(x).position.distance(center) - 1.3));
    other_way = std::max(other_way, told.place(x).position.distance(inverted.place(x).position));
  }
  std::cout << "a ball of triangles is off by " << below(2e-3, uneven)
            << ", with its triangles turned over by " << below(1e-12, other_way) << '\n';
  TriangulatedSurface folded =
      Polyhedron(Point(), {Vector({-3., 0., 0.}), Vector({3., 0., 0.})}, 1., Vector()).surface(0.5);
  for (Point &x : folded.vertices)
    x[2] += 0.4 * x[0] * x[0];
  triangles.triangles.pop_back();
  for (const TriangulatedSurface &wrong : {folded, triangles})
    try
    {
      StarSolid(center, wrong, 8, turn);
    }
    catch (const InputError &error)
    {
      std::cout << std::string(error.what()).substr(0, 57) << "...\n";
    }

  // Both touch along x, where the second is turned about it.
  const Superellipsoid one(Point(0., 0., 0.), Vector({1.5, 1.1, 0.8}), {{2., 2.}}, Vector());
  for (const double gap : {1e-6, -1e-3, -0.2})
  {
    const Superellipsoid other(Point(2.5 + gap, 0., 0.), Vector({1., 0.7, 1.2}), {{2., 2.}},
                               Vector({0.6, 0., 0.}));
    std::cout << "a gap of " << std::setprecision(6) << gap << " is told as an overlap of "
              << std::setprecision(3) << (overlap(one, other) > 0. ? overlap(one, other) : 0.) << '\n';
  }
  const Sphere left(Point(0., 0., 0.), 1.), right(Point(1.9, 0., 0.), 1.);
  std::cout << "balls .1 in each other: " << overlap(left, right) << '\n';
}
