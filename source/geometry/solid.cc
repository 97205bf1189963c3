// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/solid.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <map>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::Shape<3>)

namespace softgrain
{
namespace
{
using dealii::numbers::PI;

/// Edge of an icosahedron over the radius of the sphere through its corners.
constexpr double edge_of_icosahedron = 1.0514622242382672;

constexpr double hardly_farther = 1.25; ///< than the spacing of a surface

/// An icosahedron whose corners have the coordinates 0, 1 and the golden ratio with either sign.
TriangulatedSurface icosahedron()
{
  const double g = 0.5 * (1. + std::sqrt(5.));
  TriangulatedSurface result;
  for (unsigned int d = 0; d < 3; ++d)
    for (const double one : {-1., 1.})
      for (const double other : {-g, g})
      {
        dealii::Point<3> p;
        p[(d + 1) % 3] = one;
        p[(d + 2) % 3] = other;
        result.vertices.push_back(p);
      }
  const auto near = [&](const unsigned int a, const unsigned int b)
  { return result.vertices[a].distance(result.vertices[b]) < 2.1; };
  for (unsigned int a = 0; a < 12; ++a)
    for (unsigned int b = a + 1; b < 12; ++b)
      for (unsigned int c = b + 1; c < 12; ++c)
        if (near(a, b) && near(b, c) && near(a, c))
        {
          const auto &v = result.vertices;
          const bool outward =
              dealii::cross_product_3d(v[b] - v[a], v[c] - v[a]) * dealii::Tensor<1, 3>(v[a]) > 0.;
          result.triangles.push_back(outward ? std::array<unsigned int, 3>{{a, b, c}}
                                             : std::array<unsigned int, 3>{{a, c, b}});
        }
  return result;
}

/// Numbers the vertices of divided triangles: those on common edges are the same.
class Divider
{
public:
  Divider(const TriangulatedSurface &coarse, const unsigned int n) : coarse(coarse), n(n) {}

  TriangulatedSurface divide()
  {
    for (const auto &triangle : coarse.triangles)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j + i < n; ++j)
        {
          fine.triangles.push_back(
              {{vertex(triangle, i, j), vertex(triangle, i + 1, j), vertex(triangle, i, j + 1)}});
          if (i + j + 1 < n)
            fine.triangles.push_back(
                {{vertex(triangle, i + 1, j), vertex(triangle, i + 1, j + 1), vertex(triangle, i, j + 1)}});
        }
    return fine;
  }

private:
  /// The vertex i steps along the first side and j along the second.
  unsigned int vertex(const std::array<unsigned int, 3> &triangle, const unsigned int i, const unsigned int j)
  {
    std::map<unsigned int, unsigned int> weights; // of the corners
    for (const auto &[corner, weight] : {std::pair<unsigned int, unsigned int>(triangle[0], n - i - j),
                                         std::pair<unsigned int, unsigned int>(triangle[1], i),
                                         std::pair<unsigned int, unsigned int>(triangle[2], j)})
      if (weight > 0)
        weights[corner] = weight;
    const auto [place, is_new] = numbers.emplace(weights, fine.vertices.size());
    if (is_new)
    {
      dealii::Tensor<1, 3> sum;
      for (const auto &[corner, weight] : weights)
        sum += static_cast<double>(weight) * coarse.vertices[corner];
      fine.vertices.push_back(dealii::Point<3>(sum / static_cast<double>(n)));
    }
    return place->second;
  }

  const TriangulatedSurface &coarse;
  const unsigned int n;
  TriangulatedSurface fine;
  std::map<std::map<unsigned int, unsigned int>, unsigned int> numbers;
};
} // namespace

std::pair<Shape<3>::Place, Shape<3>::Place> Shape<3>::bounding_box() const
{
  std::pair<Place, Place> box;
  for (unsigned int d = 0; d < 3; ++d)
  {
    dealii::Tensor<1, 3> axis;
    axis[d] = 1.;
    std::tie(box.first[d], box.second[d]) = distances_from_plane(Place(), axis);
  }
  return box;
}

SurfacePlace<3> place_of(const dealii::Point<3> &position, const dealii::Tensor<1, 3> &normal)
{
  SurfacePlace<3> place;
  place.position = position;
  place.normal = normal;
  unsigned int smallest = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(normal[d]) < std::abs(normal[smallest]))
      smallest = d;
  dealii::Tensor<1, 3> axis;
  axis[smallest] = 1.;
  place.tangent[0] = axis - normal[smallest] * normal;
  place.tangent[0] /= place.tangent[0].norm();
  place.tangent[1] = dealii::cross_product_3d(normal, place.tangent[0]);
  return place;
}

TriangulatedSurface finely(const double spacing, const std::function<TriangulatedSurface(double)> &make)
{
  for (double finer = spacing;;)
  {
    TriangulatedSurface result = make(finer);
    double longest = 0.;
    for (const auto &t : result.triangles)
      for (unsigned int k = 0; k < 3; ++k)
        longest = std::max(longest, result.vertices[t[k]].distance(result.vertices[t[(k + 1) % 3]]));
    if (longest <= hardly_farther * spacing)
      return result;
    finer *= std::min(0.9, hardly_farther * spacing / longest);
  }
}

void Sphere::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.declare_entry("Radius", "0", dealii::Patterns::Double(0),
                    "Radius of a ball or of a cylinder. Units: m.");
}

void Sphere::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  center = body_center;
  radius = prm.get_double("Radius");
}

void Sphere::check(const std::string &body) const
{
  if (!(radius > 0.))
    throw InputError("'" + body + "/Radius' = '" + std::to_string(radius) +
                     "' leaves the body empty: it must be greater than 0");
}

double Sphere::volume() const
{
  return 4. / 3. * PI * radius * radius * radius;
}

SurfacePlace<3> Sphere::place(const Place &x) const
{
  dealii::Tensor<1, 3> normal = x - center;
  normal /= normal.norm();
  SurfacePlace<3> result = place_of(center + radius * normal, normal);
  result.bend[0][0] = result.bend[1][1] = 1. / radius;
  return result;
}

std::pair<double, double> Sphere::distances_from_plane(const Place &point,
                                                       const dealii::Tensor<1, 3> &normal) const
{
  const double middle = (center - point) * normal;
  return {middle - radius, middle + radius};
}

/// A place between that of the box nearest to the centre and the corner that is farthest from it.
std::optional<Sphere::Place> Sphere::surface_in_box(const Place &lower, const Place &upper) const
{
  Place near = center, far = lower;
  for (unsigned int d = 0; d < 3; ++d)
  {
    near[d] = std::clamp(center[d], lower[d], upper[d]);
    if (upper[d] - center[d] > center[d] - lower[d])
      far[d] = upper[d];
  }
  if (!(depth(near) > 0. && depth(far) < 0.))
    return std::nullopt;
  for (unsigned int halving = 0; halving < 50; ++halving)
  {
    const Place middle = near + 0.5 * (far - near);
    (depth(middle) > 0. ? near : far) = middle;
  }
  return near;
}

TriangulatedSurface Sphere::surface(const double spacing) const
{
  const unsigned int n =
      std::max(1, static_cast<int>(std::ceil(edge_of_icosahedron * radius / spacing - 1e-9)));
  const TriangulatedSurface coarse = icosahedron();
  TriangulatedSurface result = Divider(coarse, n).divide();
  for (Place &x : result.vertices)
    x = center + radius / x.norm() * (x - Place());
  return result;
}

namespace
{
[[maybe_unused]] const bool registered =
    Registry<Shape<3>>::instance().add("sphere", "Radius", [] { return std::make_unique<Sphere>(); });
}
} // namespace softgrain
