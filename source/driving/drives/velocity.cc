// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/expression.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace softgrain
{
namespace
{
/// The wall moves along its normal as a formula of time says.
class VelocityDrive final : public WallDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Velocity", "0", dealii::Patterns::Anything(),
                      "Velocity along the normal, positive towards the bodies; a formula of t "
                      "(doc/formulas.md). Units: m/s.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) override
  {
    velocity = formula_of_time(prm.get("Velocity"), wall + "/Velocity");
  }

  bool prescribed() const override { return true; }

  WallDemand demand(const WallStep &step) const override
  {
    // The middle of the step: a wall ends where its formula integrates to, to second order.
    return {velocity({step.middle()}), 0.};
  }

private:
  Expression velocity{"0", {"t"}};
};

[[maybe_unused]] const bool registered = Registry<WallDrive>::instance().add(
    "velocity", "the wall moves as 'Velocity' says", [] { return std::make_unique<VelocityDrive>(); });
} // namespace
} // namespace softgrain
