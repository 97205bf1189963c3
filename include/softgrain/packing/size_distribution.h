// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_size_distribution_h
#define softgrain_packing_size_distribution_h

#include <softgrain/base/random.h>

#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// Diameters of disks between a smallest and a largest one.
struct SizeDistribution
{
  enum class Form
  {
    uniform_area,     ///< areas are uniform between the smallest and the largest (the thesis): density ∝ d
    uniform_diameter, ///< diameters are uniform
    equal_areas,      ///< every class of diameters holds the same area in all: density ∝ d^-2
    power_law,        ///< density ∝ d^exponent
    gaussian,         ///< normal, cut off at the smallest and the largest
    log_normal        ///< the logarithm is normal, cut off likewise
  };

  double smallest = 0; ///< [m]
  double largest = 0;  ///< [m]
  Form form = Form::uniform_area;
  double mean = 0;      ///< of `gaussian` and `log_normal`, before they are cut off [m]
  double deviation = 0; ///< their standard deviation [m]
  double exponent = 0;  ///< of `power_law`

  /// One diameter [m].
  double draw(Uniform &random) const { return quantile(random()); }

  /// The diameter below which the share @p u in [0, 1] of all disks is [m].
  double quantile(double u) const;

  /// Mean area of a disk [m^2].
  double mean_area() const;

  /// Declares `Smallest diameter`, `Largest diameter`, `Size distribution` and what belongs to it where the
  /// handler stands.
  static void
  declare_parameters(dealii::ParameterHandler &prm, const std::string &smallest, const std::string &largest);
  /// @throw InputError when the largest is below the smallest, or what a distribution needs is missing or has
  /// no effect;
  /// @p section is where the handler stands.
  void parse_parameters(dealii::ParameterHandler &prm, const std::string &section);
};
} // namespace softgrain

#endif
