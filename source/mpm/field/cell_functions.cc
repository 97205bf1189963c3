// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/field/cell_functions.h>
#include <softgrain/mpm/field/lattice_box.h>

#include <array>

namespace softgrain::mpm
{
namespace
{
/// Products of one-dimensional functions that depend on the extent of the point.
template <int dim>
void multiply(const ShapeFunction &shape,
              const std::vector<std::array<int, dim>> &offsets,
              const dealii::Point<dim> &unit,
              const double half_extent,
              std::vector<double> &values,
              std::vector<dealii::Tensor<1, dim>> &slopes)
{
  std::array<ShapeFunction::Values, dim> n, dn;
  for (unsigned int d = 0; d < dim; ++d)
    shape.evaluate(unit[d], half_extent, n[d], dn[d]);
  for (unsigned int k = 0; k < values.size(); ++k)
  {
    values[k] = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      values[k] *= n[d][offsets[k][d]];
  }
  for (unsigned int k = 0; k < slopes.size(); ++k)
    for (unsigned int d = 0; d < dim; ++d)
    {
      slopes[k][d] = dn[d][offsets[k][d]];
      for (unsigned int e = 0; e < dim; ++e)
        if (e != d)
          slopes[k][d] *= n[e][offsets[k][e]];
    }
}
} // namespace

template <int dim>
CellFunctions<dim>::CellFunctions(const ShapeFunction &shape) : shape(&shape)
{
  const int n = shape.n_nodes(), n_core = shape.degree() + 1, skipped = (n - n_core) / 2;
  Offset first, last;
  first.fill(0);
  last.fill(n - 1);
  for_box<dim>(first, last,
               [&](const Offset &offset)
               {
                 bool inside = true;
                 for (unsigned int d = 0; d < dim; ++d)
                   inside = inside && offset[d] >= skipped && offset[d] < skipped + n_core;
                 if (inside)
                   core_nodes.push_back(offsets.size());
                 offsets.push_back(offset);
               });
  std::vector<dealii::Point<1>> places;
  for (int i = 0; i < n_core; ++i)
    places.emplace_back(skipped + i);
  extrapolation.resize(skipped);
  for (const auto &polynomial : dealii::Polynomials::generate_complete_Lagrange_basis(places))
    extrapolation.push_back(polynomial);
  const std::vector<ShapeFunction::Polynomial> polynomials = shape.polynomials();
  if (!polynomials.empty())
    products.emplace(polynomials);
  for (const ShapeFunction::Polynomial &polynomial : polynomials)
  {
    std::vector<double> derivatives(ShapeFunction::max_nodes);
    polynomial.value(0., derivatives);
    coefficients.emplace_back();
    double factorial = 1.;
    for (unsigned int power = 0; power < derivatives.size(); ++power)
    {
      coefficients.back()[power] = derivatives[power] / factorial;
      factorial *= power + 1;
    }
  }
}

template <int dim>
void CellFunctions<dim>::evaluate(const dealii::Point<dim> &unit,
                                  const double half_extent,
                                  std::vector<double> &values,
                                  std::vector<dealii::Tensor<1, dim>> &slopes) const
{
  if (!products)
    return multiply<dim>(*shape, offsets, unit, half_extent, values, slopes);
  std::vector<dealii::Tensor<2, dim>> no_second;
  std::vector<dealii::Tensor<3, dim>> no_third;
  std::vector<dealii::Tensor<4, dim>> no_fourth;
  products->evaluate(unit, values, slopes, no_second, no_third, no_fourth);
}

template <int dim>
typename CellFunctions<dim>::Factors CellFunctions<dim>::factors(const dealii::Point<dim> &unit) const
{
  Factors result{};
  for (unsigned int d = 0; d < dim; ++d)
  {
    auto &[value, slope, curvature] = result[d];
    if (coefficients.empty())
      shape->evaluate(unit[d], 0., value, slope);
    for (unsigned int i = 0; i < coefficients.size(); ++i)
      for (unsigned int power = ShapeFunction::max_nodes; power-- > 0;)
      {
        curvature[i] = curvature[i] * unit[d] + 2. * slope[i];
        slope[i] = slope[i] * unit[d] + value[i];
        value[i] = value[i] * unit[d] + coefficients[i][power];
      }
  }
  return result;
}

template <int dim>
double CellFunctions<dim>::extrapolate(const unsigned int k, const dealii::Point<dim> &place) const
{
  double value = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    value *= extrapolation[offsets[k][d]].value(place[d]);
  return value;
}

template class CellFunctions<2>;
template class CellFunctions<3>;
} // namespace softgrain::mpm
