// SPDX-License-Identifier: LGPL-2.1-or-later
// A wall whose position is given: it ends every step where the formula says.
#include <softgrain/base/expression.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>

using namespace softgrain;

class TrackDrive final : public WallDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Travel", "0", dealii::Patterns::Anything(),
                      "Way along the normal since the start, a formula of t. Units: m.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) override
  {
    travel = formula_of_time(prm.get("Travel"), wall + "/Travel");
  }

  bool prescribed() const override { return true; }

  WallDemand demand(const WallStep &step) const override
  {
    return {(travel({step.begin + step.dt}) - step.travel) / step.dt, 0.};
  }

private:
  Expression travel{"0", {"t"}};
};

[[maybe_unused]] const bool registered = Registry<WallDrive>::instance().add(
    "track", "the wall is where 'Travel' says", [] { return std::make_unique<TrackDrive>(); });
