// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/size_distribution.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace softgrain
{
double SizeDistribution::draw(Uniform &random) const
{
  // The inverse of the distribution function.
  const double u = random();
  switch (form)
  {
  case Form::uniform_diameter:
    return smallest + u * (largest - smallest);
  case Form::equal_areas:
    return 1. / (1. / smallest - u * (1. / smallest - 1. / largest));
  default:
    return std::sqrt(smallest * smallest + u * (largest * largest - smallest * smallest));
  }
}

double SizeDistribution::mean_area() const
{
  const double a = smallest, b = largest;
  const double mean_square = form == Form::uniform_diameter ? (a * a + a * b + b * b) / 3.
                             : form == Form::equal_areas    ? a * b
                                                            : 0.5 * (a * a + b * b);
  return 0.25 * dealii::numbers::PI * mean_square;
}

void SizeDistribution::declare_parameters(dealii::ParameterHandler &prm,
                                          const std::string &smallest,
                                          const std::string &largest)
{
  using namespace dealii::Patterns;
  constexpr double tiny = 1e-300; // patterns know no "greater than zero"
  prm.declare_entry("Smallest diameter", smallest, Double(tiny), "Smallest diameter of a disk. Units: m.");
  prm.declare_entry("Largest diameter", largest, Double(tiny), "Largest diameter of a disk. Units: m.");
  prm.declare_entry(
      "Size distribution", "uniform area", Selection("uniform area|uniform diameter|equal areas"),
      "uniform area: areas are drawn uniformly between the smallest and the largest (the thesis); uniform "
      "diameter: diameters are; equal areas: all classes of diameters have the same total area.");
}

void SizeDistribution::parse_parameters(dealii::ParameterHandler &prm, const std::string &section)
{
  smallest = prm.get_double("Smallest diameter");
  largest = prm.get_double("Largest diameter");
  const std::string name = prm.get("Size distribution");
  form = name == "uniform area"       ? Form::uniform_area
         : name == "uniform diameter" ? Form::uniform_diameter
                                      : Form::equal_areas;
  if (largest < smallest)
    throw InputError("'" + section + "/Largest diameter' = '" + prm.get("Largest diameter") +
                     "' is not allowed: it must be at least 'Smallest diameter' = '" +
                     prm.get("Smallest diameter") + "'");
  // Steps and cells of the search follow the largest disks; the smallest ones would never come to rest.
  if (largest > 1000. * smallest)
    throw InputError("'" + section + "/Smallest diameter' = '" + prm.get("Smallest diameter") +
                     "' is not allowed: it must be at least a thousandth of 'Largest diameter' = '" +
                     prm.get("Largest diameter") + "'");
}
} // namespace softgrain
