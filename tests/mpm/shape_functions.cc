// SPDX-License-Identifier: LGPL-2.1-or-later
// Every shape function, in two and three dimensions, at random places of a cell: the values sum up to one and
// reproduce the place, the slopes are the differences of the values, and linear and quadratic are deal.II's
// FE_Q.
#include <softgrain/mpm/field/cell_functions.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace softgrain;

namespace
{
template <int dim>
struct Evaluation
{
  Evaluation(const mpm::CellFunctions<dim> &functions, const dealii::Point<dim> &unit)
      : values(functions.n()), slopes(functions.n())
  {
    functions.evaluate(unit, 0.2, values, slopes);
  }
  std::vector<double> values;
  std::vector<dealii::Tensor<1, dim>> slopes;
};

/// The largest differences from what must be.
struct Errors
{
  double sum = 0., place = 0., slope = 0., element = 0.;
};

template <int dim>
void compare_with_element(const unsigned int degree,
                          const dealii::Point<dim> &unit,
                          const Evaluation<dim> &at,
                          Errors &errors)
{
  const dealii::FE_Q<dim> element(degree);
  const std::vector<unsigned int> hierarchic =
      dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(degree);
  for (unsigned int k = 0; k < at.values.size(); ++k)
  {
    errors.element =
        std::max(errors.element, std::abs(at.values[k] - element.shape_value(hierarchic[k], unit)));
    errors.element =
        std::max(errors.element, (at.slopes[k] - element.shape_grad(hierarchic[k], unit)).norm());
  }
}

template <int dim>
void check(const std::string &name)
{
  const auto shape = mpm::create_shape_function(name);
  const mpm::CellFunctions<dim> functions(*shape);
  std::mt19937 generator(1);
  std::uniform_real_distribution<> uniform(0.01, 0.99);
  constexpr double step = 1e-6;
  Errors errors;
  for (unsigned int trial = 0; trial < 50; ++trial)
  {
    dealii::Point<dim> unit;
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = uniform(generator);
    const Evaluation<dim> at(functions, unit);
    double sum = -1.;
    dealii::Tensor<1, dim> place = -unit;
    for (unsigned int k = 0; k < functions.n(); ++k)
    {
      sum += at.values[k];
      for (unsigned int d = 0; d < dim; ++d)
        place[d] += at.values[k] * ((functions.offset(k)[d] + shape->first_node()) /
                                        static_cast<double>(shape->nodes_per_edge()) +
                                    shape->node_shift());
    }
    errors.sum = std::max(errors.sum, std::abs(sum));
    errors.place = std::max(errors.place, place.norm());
    for (unsigned int d = 0; d < dim; ++d)
    {
      dealii::Point<dim> before = unit, after = unit;
      before[d] -= step;
      after[d] += step;
      const Evaluation<dim> below(functions, before), above(functions, after);
      for (unsigned int k = 0; k < functions.n(); ++k)
        errors.slope = std::max(
            errors.slope, std::abs((above.values[k] - below.values[k]) / (2. * step) - at.slopes[k][d]));
    }
    if (name == "linear" || name == "quadratic")
      compare_with_element<dim>(shape->degree(), unit, at, errors);
  }
  const auto passed = [](const double error, const double limit) { return error < limit ? "yes" : "no"; };
  std::cout << name << " in " << dim << "d: sum is one " << passed(errors.sum, 1e-13) << ", place "
            << passed(errors.place, 1e-13) << ", slopes " << passed(errors.slope, 1e-8);
  if (name == "linear" || name == "quadratic")
    std::cout << ", FE_Q " << passed(errors.element, 1e-13);
  std::cout << '\n';
}
} // namespace

int main()
{
  for (const std::string &name : Registry<mpm::ShapeFunction>::instance().names())
  {
    check<2>(name);
    check<3>(name);
  }
}
