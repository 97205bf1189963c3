// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/// Semi-axes of the ellipsoid with the volume and the second moments of what a surface encloses.
struct InertiaAxes
{
  explicit InertiaAxes(const BodyState<3> &body);

  std::array<double, 3> semi_axis{}; ///< the longest first [m]
  dealii::Tensor<1, 3> longest;      ///< unit
  double volume = 0., area = 0.;     ///< [m^3, m^2]
};

InertiaAxes::InertiaAxes(const BodyState<3> &body)
{
  // Tetrahedra from one vertex to all triangles; relative to it, so that bodies far from the origin keep
  // their digits.
  const std::vector<dealii::Point<3>> &vertices = body.outline[0];
  dealii::Tensor<1, 3> first;
  dealii::SymmetricTensor<2, 3> second;
  for (const std::array<unsigned int, 3> &triangle : body.triangles)
  {
    std::array<dealii::Tensor<1, 3>, 3> corner;
    for (unsigned int k = 0; k < 3; ++k)
      corner[k] = vertices[triangle[k]] - vertices[0];
    const double part = dealii::cross_product_3d(corner[0], corner[1]) * corner[2] / 6.;
    const dealii::Tensor<1, 3> sum = corner[0] + corner[1] + corner[2];
    volume += part;
    area += 0.5 * dealii::cross_product_3d(corner[1] - corner[0], corner[2] - corner[0]).norm();
    first += part / 4. * sum;
    second += part / 20. * symmetrize(outer_product(sum, sum));
    for (const dealii::Tensor<1, 3> &x : corner)
      second += part / 20. * symmetrize(outer_product(x, x));
  }
  if (!(volume > 0.))
    return;
  second -= symmetrize(outer_product(first, first)) / volume;
  const auto principal = eigenvectors(second); // falling
  for (unsigned int d = 0; d < 3; ++d)
    semi_axis[d] = std::sqrt(5. * std::max(0., principal[d].first) / volume);
  longest = principal[0].second;
}

/// Form and orientation of the bodies in space.
class ShapeInSpace final : public MeasureIn<3>
{
public:
  std::vector<std::string> columns() const override
  {
    return {"aspect_ratio", "middle_over_long_axis", "short_over_middle_axis", "sphericity", "orientation_1"};
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<3> &assembly) const override
  {
    const double n = assembly.snapshot.bodies.size();
    std::array<double, 4> mean{};
    dealii::SymmetricTensor<2, 3> orientation;
    for (const BodyState<3> &body : assembly.snapshot.bodies)
    {
      const InertiaAxes axes(body);
      if (!(axes.semi_axis[2] > 0.))
        return std::vector<MeasuredValue>(5); // a surface that encloses nothing
      mean[0] += axes.semi_axis[0] / axes.semi_axis[2] / n;
      mean[1] += axes.semi_axis[1] / axes.semi_axis[0] / n;
      mean[2] += axes.semi_axis[2] / axes.semi_axis[1] / n;
      mean[3] += std::cbrt(M_PI) * std::pow(6. * axes.volume, 2. / 3.) / axes.area / n;
      orientation += symmetrize(outer_product(axes.longest, axes.longest)) / n;
    }
    if (n == 0.)
      return std::vector<MeasuredValue>(5);
    return {mean[0], mean[1], mean[2], mean[3], eigenvalues(orientation)[0]};
  }
};

[[maybe_unused]] const bool registered = register_measure<ShapeInSpace, 3>(
    "shape", "axes of inertia of the bodies, sphericity, and how far the longest axes are oriented alike");
} // namespace
} // namespace softgrain
