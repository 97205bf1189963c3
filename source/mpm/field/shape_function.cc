// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/field/shape_function.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::mpm::ShapeFunction)

namespace softgrain::mpm
{
namespace
{
/// The functions of deal.II's FE_Q: equal to one at their own node of a cell and zero at all others.
class LagrangeShape : public ShapeFunction
{
public:
  explicit LagrangeShape(const unsigned int degree) : element_degree(degree) {}
  unsigned int n_nodes() const override { return element_degree + 1; }
  int first_node() const override { return 0; }
  unsigned int nodes_per_edge() const override { return element_degree; }
  double node_shift() const override { return 0.; }
  unsigned int degree() const override { return element_degree; }
  bool may_hang() const override { return true; }
  std::vector<Polynomial> polynomials() const override
  {
    std::vector<dealii::Point<1>> nodes = dealii::FE_Q<1>(element_degree).get_unit_support_points();
    std::sort(nodes.begin(), nodes.end(), [](const auto &a, const auto &b) { return a[0] < b[0]; });
    return dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
  }

private:
  const unsigned int element_degree;
};

class LinearShape final : public LagrangeShape
{
public:
  LinearShape() : LagrangeShape(1) {}
};

class QuadraticShape final : public LagrangeShape
{
public:
  QuadraticShape() : LagrangeShape(2) {}
  bool nowhere_negative() const override { return false; }
  // With two, a cell has deformations that strain no point.
  unsigned int least_points() const override { return 3; }
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
  bool smooth() const override { return true; }
  std::vector<Polynomial> polynomials() const override
  {
    return {Polynomial({0.5, -1., 0.5}), Polynomial({0.5, 1., -1.}), Polynomial({0., 0., 0.5})};
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
        "bspline", "uniform quadratic B-splines", [] { return std::make_unique<BSplineShape>(); }),
    ShapeRegistry::instance().add(
        "quadratic",
        "FE_Q(2) of deal.II, without inertia and with three points per direction only",
        [] { return std::make_unique<QuadraticShape>(); })};
} // namespace

void ShapeFunction::evaluate(double, double, Values &, Values &) const
{
  AssertThrow(false, dealii::ExcMessage("a shape function has either polynomials or evaluate()"));
}

std::unique_ptr<ShapeFunction> create_shape_function(const std::string &name)
{
  return ShapeRegistry::instance().create(name);
}
} // namespace softgrain::mpm
