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
    equal_areas       ///< every class of diameters holds the same area in all: density ∝ d^-2
  };

  double smallest = 0; ///< [m]
  double largest = 0;  ///< [m]
  Form form = Form::uniform_area;

  /// One diameter [m].
  double draw(Uniform &random) const;

  /// Mean area of a disk [m^2].
  double mean_area() const;

  /// Declares `Smallest diameter`, `Largest diameter` and `Size distribution` where the handler stands.
  static void
  declare_parameters(dealii::ParameterHandler &prm, const std::string &smallest, const std::string &largest);
  /// @throw InputError when the largest is below the smallest; @p section is where the handler stands.
  void parse_parameters(dealii::ParameterHandler &prm, const std::string &section);
};
} // namespace softgrain

#endif
