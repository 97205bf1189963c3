// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/scene/size_distribution.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
double SizeDistribution::draw(Uniform &random) const
{
  const double u = random();
  if (!uniform_by_area)
    return smallest + u * (largest - smallest);
  // The inverse of the distribution function of p(d) = d^-2 / (1/smallest - 1/largest).
  return 1. / (1. / smallest - u * (1. / smallest - 1. / largest));
}

void SizeDistribution::declare_parameters(dealii::ParameterHandler &prm,
                                          const std::string &smallest,
                                          const std::string &largest)
{
  using namespace dealii::Patterns;
  constexpr double tiny = 1e-300; // patterns know no "greater than zero"
  prm.declare_entry("Smallest diameter", smallest, Double(tiny), "Of the disks. Units: m.");
  prm.declare_entry("Largest diameter", largest, Double(tiny), "Of the disks. Units: m.");
  prm.declare_entry("Size distribution", "uniform by area", Selection("uniform by area|uniform by number"),
                    "uniform by area: every class of diameters holds the same area (the thesis); uniform by "
                    "number: the same number.");
}

void SizeDistribution::parse_parameters(dealii::ParameterHandler &prm, const std::string &section)
{
  smallest = prm.get_double("Smallest diameter");
  largest = prm.get_double("Largest diameter");
  uniform_by_area = prm.get("Size distribution") == "uniform by area";
  if (largest < smallest)
    throw InputError("'" + section + "/Largest diameter' = '" + prm.get("Largest diameter") +
                     "' is not allowed: it must be at least 'Smallest diameter' = '" +
                     prm.get("Smallest diameter") + "'");
}
} // namespace softgrain
