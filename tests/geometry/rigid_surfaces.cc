// SPDX-License-Identifier: LGPL-2.1-or-later
// Sheets that obstacles in space are made of: places lie half a thickness from the skeleton, normals and
// bends are those of differences, a ray meets what is known in closed form, and what triangles make is what
// revolution makes. STL files are read as they were written, binary or not, and others are refused.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/revolved_surface.h>
#include <softgrain/geometry/stl_file.h>
#include <softgrain/geometry/triangle_sheet.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
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

const double thickness = 0.4;

/// Places all around, but for those within the thickness: in a notch these have no place of the surface near.
void look_at(const std::string &name, const RigidSurface &surface)
{
  double off = 0., turned = 0., third = 0., moved = 0.;
  unsigned int n = 0;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k)
      {
        const Point x(0.731 * i + 0.11, 0.717 * j + 0.07, 0.689 * k - 0.05);
        const auto here = surface.nearest(x, 10.);
        if (!here || surface.height(x, 10.) < 0.)
          continue;
        ++n;
        off = std::max(off, std::abs(surface.height(here->position, 10.)));
        turned =
            std::max({turned, std::abs(here->normal.norm() - 1.), std::abs(here->tangent[0] * here->normal),
                      std::abs(here->tangent[1] * here->normal),
                      (dealii::cross_product_3d(here->tangent[0], here->tangent[1]) - here->normal).norm()});
        for (const double angle : {0.3, 1.4, 2.5})
        {
          constexpr double way = 1e-4;
          const dealii::Tensor<1, 2> a({way * std::cos(angle), way * std::sin(angle)});
          const Point told = here->position + a[0] * here->tangent[0] + a[1] * here->tangent[1] -
                             0.5 * (a * (here->bend * a)) * here->normal;
          third = std::max(third, std::abs(surface.height(told, 10.)) / (way * way * way));
          moved = std::max(moved, surface.move(*here, a).position.distance(told) / (way * way));
        }
      }
  std::cout << name << ": " << n << " places, off the surface " << below(1e-13, off) << ", triads "
            << below(1e-13, turned) << ", a way of 1e-4 is told to third order with a factor "
            << (third < 500. ? "below 500" : "above 500") << ", moves "
            << (moved < 20. ? "go there" : "do not") << '\n';
}

void meet(const std::string &name,
          const RigidSurface &surface,
          const Point &from,
          const Vector &way,
          const double longest,
          const double right)
{
  const auto place = surface.first_met(from, way, longest);
  std::cout << name << ": ";
  if (!place)
    std::cout << "none\n";
  else
    std::cout << "off by " << below(1e-12, std::abs((place->position - from) * way - right)) << ", normal "
              << below(1e-9, std::abs(surface.height(place->position + 0.01 * place->normal, 5.) - 0.01))
              << '\n';
}

TriangulatedSurface square(const double a)
{
  return {{{-a, -a, 0.}, {a, -a, 0.}, {a, a, 0.}, {-a, a, 0.}}, {{{0, 1, 2}}, {{0, 2, 3}}}};
}

void write_binary(const std::string &path, const TriangulatedSurface &surface)
{
  std::ofstream file(path, std::ios::binary);
  const std::string header(80, 's');
  const std::uint32_t n = surface.triangles.size();
  file.write(header.data(), 80);
  file.write(reinterpret_cast<const char *>(&n), 4);
  for (const auto &triangle : surface.triangles)
  {
    float numbers[12] = {0.F, 0.F, 1.F};
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int d = 0; d < 3; ++d)
        numbers[3 + 3 * k + d] = static_cast<float>(surface.vertices[triangle[k]][d]);
    file.write(reinterpret_cast<const char *>(numbers), sizeof numbers);
    file.write("\0\0", 2);
  }
}

void write_ascii(const std::string &path, const TriangulatedSurface &surface)
{
  std::ofstream file(path);
  file << "solid square\n";
  for (const auto &triangle : surface.triangles)
  {
    file << "facet normal 0 0 1\n outer loop\n";
    for (const unsigned int k : triangle)
      file << "  vertex " << surface.vertices[k] << '\n';
    file << " endloop\nendfacet\n";
  }
  file << "endsolid square\n";
}

void read(const std::string &path)
{
  try
  {
    const TriangulatedSurface surface = read_stl(path, 2.);
    std::cout << path << ": " << surface.triangles.size() << " triangles, " << surface.vertices.size()
              << " corners, the first at " << surface.vertices[0] << '\n';
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  const Vector up({0., 0., 1.}), tilted = Vector({0.36, 0.48, 0.8});
  const RevolvedSurface ball({{{0., 0.}}}, {0.1, 0., 0.}, up, thickness),
      rod({{{0., -1.}}, {{0., 1.}}}, {}, tilted, thickness), ring({{{1.5, 0.}}}, {}, up, thickness),
      tube({{{1.5, -2.}}, {{1.5, 2.}}}, {}, tilted, thickness),
      cone({{{0.5, -1.}}, {{2., 1.}}}, {0., 0., 0.3}, up, thickness),
      disk({{{0., 0.}}, {{2., 0.}}}, {}, up, thickness),
      drum({{{0., -1.}}, {{1.5, -1.}}, {{1.5, 1.}}, {{0., 1.}}}, {}, tilted, thickness);
  const TriangleSheet sheet(square(1.2), thickness);
  look_at("ball", ball);
  look_at("rod", rod);
  look_at("ring", ring);
  look_at("tube", tube);
  look_at("cone", cone);
  look_at("disk", disk);
  look_at("drum", drum);
  look_at("square", sheet);

  const Vector down = -up;
  meet("ray to a ball", ball, {0.2, 0.05, 1.}, down, 2., 1. - std::sqrt(0.04 - 0.01 - 0.0025));
  meet("ray beside it", ball, {0.35, 0., 1.}, down, 2., 0.);
  meet("ray to a disk", disk, {0.7, -1.1, 1.}, down, 2., 0.8);
  meet("ray to its rim", disk, {2.1, 0., 1.}, down, 2., 1. - std::sqrt(0.04 - 0.01));
  meet("ray to a square", sheet, {0.7, -1.1, 1.}, down, 2., 0.8);
  meet("ray to its corner", sheet, {1.3, 1.25, 1.}, down, 2., 1. - std::sqrt(0.04 - 0.01 - 0.0025));
  meet("ray from below", sheet, {0.7, -1.1, -1.}, up, 2., 0.8);
  meet("ray that begins within", sheet, {0.7, -1.1, 0.1}, down, 2., 0.);
  meet("ray that ends before", sheet, {0.7, -1.1, 1.}, down, 0.7, 0.);
  const Vector outwards = Vector({0.8, 0., -0.36}) / std::sqrt(0.64 + 0.1296);
  meet("ray within a tube", tube, {}, outwards, 4., 1.3);

  write_binary("binary.stl", square(1.));
  write_ascii("ascii.stl", square(1.));
  std::ofstream("flat.stl") << "solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\nendsolid\n";
  std::ofstream("cut.stl") << "solid\nvertex 0 0 0\nvertex 1 0 0\n";
  std::ofstream("text.stl") << "points of nothing";
  for (const std::string name : {"binary", "ascii", "flat", "cut", "text", "absent"})
    read(name + ".stl");
}
