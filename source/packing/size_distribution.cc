// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/size_distribution.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace softgrain
{
namespace
{
/// Share of a standard normal distribution below @p x.
double normal_share(const double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.));
}

/// The inverse of normal_share() between @p low and @p high, by halving: it grows.
double normal_quantile(const double share, double low, double high)
{
  for (unsigned int i = 0; i < 80; ++i)
  {
    const double middle = 0.5 * (low + high);
    (normal_share(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Where the share @p u of a normal distribution is that is cut off at @p low and @p high.
double quantile_between(const double u, const double low, const double high)
{
  const double below = normal_share(low), above = normal_share(high);
  return normal_quantile(below + u * (above - below), low, high);
}

/// The inverse of the distribution function of density d^@p exponent between @p a and @p b.
double power_quantile(const double u, const double a, const double b, const double exponent)
{
  const double p = exponent + 1.;
  // In units of the smallest, so that no power of a small length leaves the range of numbers.
  const double ratio = b / a;
  if (std::abs(p * std::log(ratio)) < 1e-9)
    return a * std::pow(ratio, u);
  return a * std::pow(1. + u * (std::pow(ratio, p) - 1.), 1. / p);
}
} // namespace

double SizeDistribution::quantile(const double u) const
{
  switch (form)
  {
  case Form::uniform_diameter:
    return smallest + u * (largest - smallest);
  case Form::equal_areas:
    return 1. / (1. / smallest - u * (1. / smallest - 1. / largest));
  case Form::power_law:
    return power_quantile(u, smallest, largest, exponent);
  case Form::gaussian:
    return mean +
           deviation * quantile_between(u, (smallest - mean) / deviation, (largest - mean) / deviation);
  case Form::log_normal:
  {
    const double wide = std::sqrt(std::log1p(deviation * deviation / (mean * mean)));
    const double middle = std::log(mean) - 0.5 * wide * wide;
    return std::exp(middle + wide * quantile_between(u, (std::log(smallest) - middle) / wide,
                                                     (std::log(largest) - middle) / wide));
  }
  default:
    return std::sqrt(smallest * smallest + u * (largest * largest - smallest * smallest));
  }
}

double SizeDistribution::mean_area() const
{
  const double a = smallest, b = largest;
  double mean_square = 0.;
  if (form == Form::uniform_area)
    mean_square = 0.5 * (a * a + b * b);
  else if (form == Form::uniform_diameter)
    mean_square = (a * a + a * b + b * b) / 3.;
  else if (form == Form::equal_areas)
    mean_square = a * b;
  else
  {
    // The mean over equal shares.
    constexpr unsigned int n = 2000;
    for (unsigned int i = 0; i < n; ++i)
      mean_square += std::pow(quantile((i + 0.5) / n), 2) / n;
  }
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
      "Size distribution", "uniform area",
      Selection("uniform area|uniform diameter|equal areas|power law|gaussian|log-normal"),
      "uniform area: areas are drawn uniformly between the smallest and the largest (the thesis); uniform "
      "diameter: diameters are; equal areas: all classes of diameters have the same total area; power law: "
      "their "
      "number goes with the power 'Exponent' of the diameter; gaussian and log-normal: as these, with 'Mean "
      "diameter' and "
      "'Standard deviation', cut off at the smallest and the largest.");
  prm.declare_entry("Exponent", "0", Double(-20., 20.),
                    "Power of the diameter with which numbers go in 'Size distribution' = 'power law': 0 is "
                    "uniform diameter, 1 "
                    "uniform area, -2 equal areas. Units: none.");
  prm.declare_entry(
      "Mean diameter", "0", Double(0.),
      "Mean of the distributions gaussian and log-normal, before they are cut off; 0 with others. Units: m.");
  prm.declare_entry("Standard deviation", "0", Double(0.),
                    "Standard deviation of the diameters of gaussian and log-normal, before they are cut "
                    "off; 0 with others. "
                    "Units: m.");
}

void SizeDistribution::parse_parameters(dealii::ParameterHandler &prm, const std::string &section)
{
  smallest = prm.get_double("Smallest diameter");
  largest = prm.get_double("Largest diameter");
  const std::string name = prm.get("Size distribution");
  form = name == "uniform area"       ? Form::uniform_area
         : name == "uniform diameter" ? Form::uniform_diameter
         : name == "equal areas"      ? Form::equal_areas
         : name == "power law"        ? Form::power_law
         : name == "gaussian"         ? Form::gaussian
                                      : Form::log_normal;
  exponent = prm.get_double("Exponent");
  mean = prm.get_double("Mean diameter");
  deviation = prm.get_double("Standard deviation");
  const bool normal = form == Form::gaussian || form == Form::log_normal;
  const auto refuse = [&](const std::string &key, const std::string &why)
  { throw InputError("'" + section + "/" + key + "' = '" + prm.get(key) + "' " + why); };
  const std::string with = "with '" + section + "/Size distribution' = '" + name + "'";
  if (form != Form::power_law && exponent != 0.)
    refuse("Exponent", "has no effect " + with);
  for (const auto &[key, value] : {std::pair("Mean diameter", mean), {"Standard deviation", deviation}})
    if (normal ? !(value > 0.) : value != 0.)
      refuse(key, normal ? "is not allowed " + with + ": it must be above 0" : "has no effect " + with);
  if (normal && !(mean >= smallest && mean <= largest))
    refuse("Mean diameter", "is not allowed: it must lie between 'Smallest diameter' = '" +
                                prm.get("Smallest diameter") + "' and 'Largest diameter' = '" +
                                prm.get("Largest diameter") + "'");
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
