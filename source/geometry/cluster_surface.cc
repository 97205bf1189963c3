// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/cluster_surface.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
TriangulatedSurface cluster_surface(const dealii::Point<3> &center,
                                    const std::vector<dealii::Point<3>> &centers,
                                    const std::vector<double> &radii,
                                    const double reach,
                                    const TriangulatedSurface &directions)
{
  TriangulatedSurface result;
  result.triangles = directions.triangles;
  for (const dealii::Point<3> &end : directions.vertices)
  {
    const dealii::Tensor<1, 3> direction = end / end.norm();
    double farthest = 0.;
    for (std::size_t i = 0; i < centers.size(); ++i)
    {
      const dealii::Tensor<1, 3> away = centers[i] - center;
      const double along = away * direction, grown = radii[i] + reach,
                   left = grown * grown - (away.norm_square() - along * along);
      if (left > 0.)
        farthest = std::max(farthest, along + std::sqrt(left) - reach);
    }
    result.vertices.push_back(center + farthest * direction);
  }
  return result;
}

TriangulatedSurface cluster_directions(const double n_balls, const double per_ball)
{
  // Balls that fill some 0.6 of a ball of radius 1; vertices of equilateral triangles.
  const double radius = std::cbrt(0.6 / std::max(1., n_balls));
  const double area = dealii::numbers::PI * radius * radius / per_ball;
  return Sphere(dealii::Point<3>(), 1.).surface(std::sqrt(2. / std::sqrt(3.) * area));
}

double enclosed_volume(const TriangulatedSurface &surface)
{
  double sum = 0.;
  const dealii::Point<3> &origin = surface.vertices.front();
  for (const std::array<unsigned int, 3> &triangle : surface.triangles)
    sum += (surface.vertices[triangle[0]] - origin) *
           cross_product_3d(surface.vertices[triangle[1]] - origin, surface.vertices[triangle[2]] - origin) /
           6.;
  return sum;
}
} // namespace softgrain
