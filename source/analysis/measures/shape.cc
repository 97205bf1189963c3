// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/anisotropy.h>
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
/// Principal directions of the area inside the outline of @p body, and its extents along them.
struct PrincipalAxes
{
  explicit PrincipalAxes(const BodyState<2> &body);

  double aspect_ratio = 1.;
  double angle = 0.; ///< of the longer axis [rad]
};

PrincipalAxes::PrincipalAxes(const BodyState<2> &body)
{
  // Second moments of a polygon as the sum over its edges; holes are clockwise and count negative. Relative
  // to one point, so that bodies far from the origin keep their digits.
  const dealii::Point<2> origin = body.outline[0][0];
  double area = 0.;
  dealii::Tensor<1, 2> first;
  dealii::SymmetricTensor<2, 2> second;
  for (const auto &ring : body.outline)
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const dealii::Tensor<1, 2> a = ring[i] - origin, b = ring[(i + 1) % ring.size()] - origin;
      const double cross = a[0] * b[1] - a[1] * b[0];
      area += cross / 2.;
      first += cross / 6. * (a + b);
      for (unsigned int d = 0; d < 2; ++d)
        for (unsigned int e = d; e < 2; ++e)
          second[d][e] += cross / 24. * (2. * a[d] * a[e] + 2. * b[d] * b[e] + a[d] * b[e] + a[e] * b[d]);
    }
  for (unsigned int d = 0; d < 2; ++d)
    for (unsigned int e = d; e < 2; ++e)
      second[d][e] -= first[d] * first[e] / area;
  angle = 0.5 * std::atan2(2. * second[0][1], second[0][0] - second[1][1]);

  double lower[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  double upper[2] = {-lower[0], -lower[1]};
  const dealii::Tensor<1, 2> along({std::cos(angle), std::sin(angle)}), across({-along[1], along[0]});
  for (const auto &ring : body.outline)
    for (const dealii::Point<2> &vertex : ring)
    {
      const double x[2] = {(vertex - origin) * along, (vertex - origin) * across};
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], x[d]);
        upper[d] = std::max(upper[d], x[d]);
      }
    }
  const double length = upper[0] - lower[0], width = upper[1] - lower[1];
  // Where both are nearly the same, moments and extents may disagree about which is the longer.
  aspect_ratio = std::max(length, width) / std::min(length, width);
  if (width > length)
    angle += M_PI / 2.;
}

/// Form and orientation of the bodies @cite nguyen2016, eqs. (4.7)-(4.11).
class Shape final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"aspect_ratio", "shape_strain", "orientation_anisotropy", "shape_anisotropy", "orientation_rad"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    const double n = assembly.snapshot.bodies.size();
    if (n == 0.)
      return {std::nullopt, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
    double aspect_ratio = 0.;
    dealii::SymmetricTensor<2, 2> orientation;
    for (const BodyState<2> &body : assembly.snapshot.bodies)
    {
      const PrincipalAxes shape(body);
      aspect_ratio += shape.aspect_ratio / n;
      const dealii::Tensor<1, 2> axis({std::cos(shape.angle), std::sin(shape.angle)});
      orientation += symmetrize(outer_product(axis, axis)) / n;
    }
    const double anisotropy = 2. * eigenvalue_difference(orientation);
    const double strain = (aspect_ratio - 1.) / (aspect_ratio + 1.);
    return {aspect_ratio, strain, anisotropy, strain * anisotropy / 2., principal_angle(orientation)};
  }
};

[[maybe_unused]] const bool registered = register_measure<Shape>(
    "shape", "aspect ratio, mean strain of the bodies, and how far they are oriented alike");
} // namespace
} // namespace softgrain
