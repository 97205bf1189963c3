// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
/// The wall is a body of one degree of freedom, along its normal, that a pressure moves.
class PressureDrive final : public WallDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Pressure", "0", dealii::Patterns::Anything(),
                      "With 'Drive = pressure': pressure towards the bodies, acting on the length between "
                      "the walls beside it; a formula of t (doc/formulas.md). Units: Pa.");
    prm.declare_entry("Mass", "0", dealii::Patterns::Double(0),
                      "With 'Drive = pressure': mass of the wall. Units: kg/m.");
    prm.declare_entry(
        "Damping", "0", dealii::Patterns::Double(0),
        "With 'Drive = pressure': force that resists the motion, per velocity. Units: kg/(m s).");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) override
  {
    pressure = formula_of_time(prm.get("Pressure"), wall + "/Pressure");
    resistance = {prm.get_double("Mass"), prm.get_double("Damping")};
    if (!(resistance.mass > 0.))
      throw InputError("'" + wall + "/Mass' = '" + prm.get("Mass") +
                       "' is not allowed with 'Drive' = 'pressure': it must be greater than 0");
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
                                        "it has a 'Mass' and moves along its normal under 'Pressure'",
                                        [] { return std::make_unique<PressureDrive>(); });
} // namespace
} // namespace softgrain
