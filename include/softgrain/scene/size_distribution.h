// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_size_distribution_h
#define softgrain_scene_size_distribution_h

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
  double smallest = 0;         ///< [m]
  double largest = 0;          ///< [m]
  bool uniform_by_area = true; ///< every class of diameters holds the same area; false: the same number

  /// One diameter [m]: density ∝ d^-2 when uniform by area, constant when by number.
  double draw(Uniform &random) const;

  /// Declares `Smallest diameter`, `Largest diameter` and `Size distribution` where the handler stands.
  static void
  declare_parameters(dealii::ParameterHandler &prm, const std::string &smallest, const std::string &largest);
  /// @throw InputError when the largest is below the smallest; @p section is where the handler stands.
  void parse_parameters(dealii::ParameterHandler &prm, const std::string &section);
};
} // namespace softgrain

#endif
