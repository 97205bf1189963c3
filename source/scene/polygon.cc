// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/scene/polygon.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/// Keeps the part of @p polygon where sign * (x_d - limit) >= 0.
Polygon
clip_to_half_space(const Polygon &polygon, const unsigned int d, const double limit, const double sign)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const dealii::Point<2> &a = polygon[i];
    const dealii::Point<2> &b = polygon[(i + 1) % polygon.size()];
    const double sa = sign * (a[d] - limit), sb = sign * (b[d] - limit);
    if (sa >= 0.)
      result.push_back(a);
    if ((sa > 0. && sb < 0.) || (sa < 0. && sb > 0.))
    {
      dealii::Point<2> cut = a + (sa / (sa - sb)) * (b - a);
      cut[d] = limit;
      result.push_back(cut);
    }
  }
  return result;
}

Polygon
circle(const dealii::Point<2> &center, const double radius, const double spacing, const bool clockwise)
{
  const unsigned int n = std::max(12, static_cast<int>(std::ceil(2. * M_PI * radius / spacing)));
  Polygon polygon(n);
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = (clockwise ? -1. : 1.) * 2. * M_PI * i / n;
    polygon[i] = center + radius * dealii::Tensor<1, 2>({std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

Polygon subdivide(const Polygon &corners, const double spacing)
{
  Polygon polygon;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const dealii::Tensor<1, 2> edge = corners[(i + 1) % corners.size()] - corners[i];
    const unsigned int n = std::max(1, static_cast<int>(std::ceil(edge.norm() / spacing - 1e-9)));
    for (unsigned int k = 0; k < n; ++k)
      polygon.push_back(corners[i] + (static_cast<double>(k) / n) * edge);
  }
  return polygon;
}
} // namespace

double signed_area(const Polygon &polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    // Relative to the first vertex, so that small polygons far from the origin keep their digits.
    const dealii::Tensor<1, 2> a = polygon[i] - polygon[0];
    const dealii::Tensor<1, 2> b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

std::pair<double, dealii::Point<2>> area_and_centroid(const Polygon &polygon)
{
  if (polygon.empty())
    return {0., dealii::Point<2>()};
  double twice = 0;
  dealii::Tensor<1, 2> moment, mean;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const dealii::Tensor<1, 2> a = polygon[i] - polygon[0];
    const dealii::Tensor<1, 2> b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const double cross = a[0] * b[1] - a[1] * b[0];
    twice += cross;
    moment += cross * (a + b) / 3.;
    mean += a / static_cast<double>(polygon.size());
  }
  if (std::abs(twice) < 1e-300)
    return {0., polygon[0] + mean};
  return {0.5 * twice, polygon[0] + moment / twice};
}

Polygon clip_to_box(const Polygon &polygon, const dealii::Point<2> &lower, const dealii::Point<2> &upper)
{
  Polygon result = polygon;
  for (unsigned int d = 0; d < 2; ++d)
  {
    result = clip_to_half_space(result, d, lower[d], 1.);
    result = clip_to_half_space(result, d, upper[d], -1.);
  }
  return result;
}

std::vector<Polygon> make_outline(const BodyDescription<2> &body, const double spacing)
{
  switch (body.shape)
  {
  case BodyShape::disk:
  {
    std::vector<Polygon> outline = {circle(body.center, body.radius, spacing, false)};
    if (body.inner_radius > 0.)
      outline.push_back(circle(body.center, body.inner_radius, spacing, true));
    return outline;
  }
  case BodyShape::rectangle:
  {
    const dealii::Tensor<1, 2> e({std::cos(body.angle), std::sin(body.angle)}), f({-e[1], e[0]});
    const dealii::Tensor<1, 2> a = 0.5 * body.size[0] * e, b = 0.5 * body.size[1] * f;
    return {subdivide({body.center - a - b, body.center + a - b, body.center + a + b, body.center - a + b},
                      spacing)};
  }
  case BodyShape::polygon:
  {
    Polygon corners = body.vertices;
    if (signed_area(corners) < 0.)
      std::reverse(corners.begin(), corners.end());
    return {subdivide(corners, spacing)};
  }
  }
  return {};
}
} // namespace softgrain
