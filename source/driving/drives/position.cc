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
/// The wall is where a formula of time says, at the end of every step.
class PositionDrive final : public WallDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Position", "0", dealii::Patterns::Anything(),
                      "With 'Drive = position': way along the normal from 'Point', positive towards the "
                      "bodies; a formula of t that is 0 at the start (doc/formulas.md). Units: m.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) override
  {
    position = formula_of_time(prm.get("Position"), wall + "/Position");
    if (position({0.}) != 0.)
      throw InputError("'" + wall + "/Position' = '" + prm.get("Position") +
                       "' is not allowed: the way from 'Point' must be 0 at the start");
  }

  bool prescribed() const override { return true; }

  WallDemand demand(const WallStep &step) const override
  {
    return {(position({step.begin + step.dt}) - step.travel) / step.dt, 0.};
  }

private:
  Expression position{"0", {"t"}};
};

[[maybe_unused]] const bool registered = Registry<WallDrive>::instance().add(
    "position", "the wall is where 'Position' says", [] { return std::make_unique<PositionDrive>(); });
} // namespace
} // namespace softgrain
