// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdlib>

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

/// The wall is a body of one degree of freedom, along its normal, that a pressure moves.
class PressureDrive final : public WallDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Pressure", "0", dealii::Patterns::Anything(),
                      "With 'Drive = pressure': pressure towards the bodies, acting on the length between "
                      "the walls beside it; a formula of t (doc/formulas.md). Units: Pa.");
    prm.declare_entry(
        "Mass", "automatic", dealii::Patterns::Anything(),
        "With 'Drive = pressure': mass of the wall, or automatic: a tenth of that of all bodies. "
        "Units: kg/m.");
    prm.declare_entry("Damping", "automatic", dealii::Patterns::Anything(),
                      "With 'Drive = pressure': force that resists the motion, per velocity, or automatic: "
                      "twice the root of mass times pressure. Units: kg/(m s).");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) override
  {
    pressure = formula_of_time(prm.get("Pressure"), wall + "/Pressure");
    resistance = {number_or_automatic(prm, wall, "Mass", false),
                  number_or_automatic(prm, wall, "Damping", true)};
  }

  bool prescribed() const override { return false; }
  WallDemand demand(const WallStep &step) const override { return {0., pressure({step.middle()})}; }
  WallInertia inertia() const override { return resistance; }

private:
  Expression pressure{"0", {"t"}};
  WallInertia resistance;
};

[[maybe_unused]] const bool registered =
    Registry<WallDrive>::instance().add("pressure",
                                        "it moves along its normal under 'Pressure'",
                                        [] { return std::make_unique<PressureDrive>(); });
} // namespace
} // namespace softgrain
