// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_settings_h
#define softgrain_bpm_settings_h

#include <softgrain/bpm/dynamics_settings.h>
#include <softgrain/driving/step_control.h>
#include <softgrain/packing/size_distribution.h>

#include <cstdint>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain::bpm
{
/// What bodies are filled with.
struct PrimarySettings
{
  SizeDistribution sizes;
  unsigned int number = 0; ///< per body; 0: as many as fill its shape
  std::uint64_t seed = 0;
  unsigned int variants = 0;   ///< fillings that bodies of one shape share; 0: every body has its own
  std::string strength = "1";  ///< of the attraction over that of the law, a formula of x, y and r
  double strength_spread = 0;  ///< of whole bodies: largest deviation of a factor from 1
  std::string aggregate_file;  ///< keeps prepared aggregates for the next run; may be empty
  bool keep_aggregates = true; ///< whether new ones are written into that file
};

/// Everything the bonded-particle model reads from a parameter file beside the scene.
struct Settings
{
  PrimarySettings primaries;
  StepSettings step;
  double step_fraction = 0;       ///< of the time in which attraction closes a gap, when no step is given
  double largest_penetration = 0; ///< that a step may leave, in mean diameters
  double wall_floor = 0;          ///< over F0/a0 times the side of the primaries' area
  bool inner_contacts_in_output = true;
  DynamicsSettings dynamics; ///< friction between bodies comes from the scene

  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @throw InputError when values do not fit together.
  void parse_parameters(dealii::ParameterHandler &prm);
};
} // namespace softgrain::bpm

#endif
