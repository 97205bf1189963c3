// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/field/shape_function.h>

#include <algorithm>
#include <cmath>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::mpm::ShapeFunction)

namespace softgrain::mpm
{
namespace
{
/// Hats on the vertices, FE_Q(1).
class LinearShape final : public ShapeFunction
{
public:
  unsigned int n_nodes() const override { return 2; }
  int first_node() const override { return 0; }
  double node_shift() const override { return 0.; }
  unsigned int degree() const override { return 1; }
  void evaluate(const double xi, const double, Values &values, Values &slopes) const override
  {
    values = {{1. - xi, xi, 0., 0.}};
    slopes = {{-1., 1., 0., 0.}};
  }
};

/// Hats averaged over the initial extent of the point (uniform GIMP, Bardenhagen and Kober 2004).
class GimpShape final : public ShapeFunction
{
public:
  unsigned int n_nodes() const override { return 4; }
  int first_node() const override { return -1; }
  double node_shift() const override { return 0.; }
  unsigned int degree() const override { return 1; }
  bool uses_extent() const override { return true; }
  void evaluate(const double xi, const double half_extent, Values &values, Values &slopes) const override
  {
    // The mean of a hat over [r-l, r+l] is a difference of its primitive; limits l -> 0 is the hat itself.
    const double l = std::clamp(half_extent, 1e-6, 0.5);
    for (unsigned int k = 0; k < 4; ++k)
    {
      const double r = xi - (static_cast<int>(k) - 1);
      values[k] = (primitive(r + l) - primitive(r - l)) / (2. * l);
      slopes[k] = (hat(r + l) - hat(r - l)) / (2. * l);
    }
  }

private:
  static double hat(const double r) { return std::max(0., 1. - std::abs(r)); }
  static double primitive(const double r)
  {
    const double c = std::clamp(r, -1., 1.);
    return c < 0. ? 0.5 * (1. + c) * (1. + c) : 1. - 0.5 * (1. - c) * (1. - c);
  }
};

/// Uniform quadratic B-splines with knots on the cell faces, one coefficient per cell centre (Steffen et al.
/// 2008).
class BSplineShape final : public ShapeFunction
{
public:
  unsigned int n_nodes() const override { return 3; }
  int first_node() const override { return -1; }
  double node_shift() const override { return 0.5; }
  unsigned int degree() const override { return 2; }
  void evaluate(const double xi, const double, Values &values, Values &slopes) const override
  {
    values = {{0.5 * (1. - xi) * (1. - xi), 0.5 + xi * (1. - xi), 0.5 * xi * xi, 0.}};
    slopes = {{xi - 1., 1. - 2. * xi, xi, 0.}};
  }
};

using ShapeRegistry = Registry<ShapeFunction>;

[[maybe_unused]] const bool registered[] = {
    ShapeRegistry::instance().add("linear",
                                  "hat functions on the corners of the cells (the thesis)",
                                  [] { return std::make_unique<LinearShape>(); }),
    ShapeRegistry::instance().add("gimp",
                                  "hat functions averaged over the extent of a point",
                                  [] { return std::make_unique<GimpShape>(); }),
    ShapeRegistry::instance().add(
        "bspline", "uniform quadratic B-splines", [] { return std::make_unique<BSplineShape>(); })};
} // namespace

std::unique_ptr<ShapeFunction> create_shape_function(const std::string &name)
{
  return ShapeRegistry::instance().create(name);
}
} // namespace softgrain::mpm
