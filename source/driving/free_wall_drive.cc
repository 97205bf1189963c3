// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/free_wall_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace softgrain
{
namespace
{
/// A number, or nothing for "automatic". @throw InputError
std::optional<double> number_or_automatic(const dealii::ParameterHandler &prm,
                                          const std::string &wall,
                                          const std::string &name,
                                          const bool may_be_zero)
{
  const std::string text = dealii::Utilities::trim(prm.get(name));
  if (text == "automatic")
    return std::nullopt;
  char *end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value) || !(may_be_zero ? value >= 0. : value > 0.))
    throw InputError("'" + wall + "/" + name + "' = '" + text + "' is not allowed: it must be a number " +
                     (may_be_zero ? "of 0 or more" : "greater than 0") + ", or automatic");
  return value;
}
} // namespace

FreeWallDrive::FreeWallDrive(std::string name, std::string key, std::string meaning)
    : name(std::move(name)), key(std::move(key)), meaning(std::move(meaning))
{
}

void FreeWallDrive::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.declare_entry(key, "0", dealii::Patterns::Anything(), "With 'Drive = " + name + "': " + meaning);
  prm.declare_entry("Mass", "automatic", dealii::Patterns::Anything(),
                    "Of a wall that is free to move: its mass, or automatic: a tenth of that of all bodies. "
                    "Units: kg/m, in space kg.");
  prm.declare_entry("Damping", "automatic", dealii::Patterns::Anything(),
                    "Of a wall that is free to move: force that resists the motion, per velocity, or "
                    "automatic: twice the root of mass times pressure, in the model bpm 0.4 times that root. "
                    "Units: kg/(m s), in space kg/s.");
}

void FreeWallDrive::parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall)
{
  formula = formula_of_time(prm.get(key), wall + "/" + key);
  resistance = {number_or_automatic(prm, wall, "Mass", false),
                number_or_automatic(prm, wall, "Damping", true)};
}
} // namespace softgrain
