// SPDX-License-Identifier: LGPL-2.1-or-later
// A drum, or a paddle: a torque turns an obstacle about its pivot, a spring turns it back, and so does what
// it meets.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/scene/obstacle_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

using namespace softgrain;

class TorqueDrive final : public ObstacleDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Moment of inertia", "0", Double(0), "About the pivot, above 0. Units: kg m.");
    prm.declare_entry("Torque", "0", Anything(), "From outside, a formula of t. Units: N.");
    prm.declare_entry("Spring", "0", Double(0), "Torque against the angle, over the angle. Units: N.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const std::string &obstacle) override
  {
    inertia = prm.get_double("Moment of inertia");
    if (!(inertia > 0.))
      throw InputError("'" + obstacle + "/Moment of inertia' must be above 0");
    torque = formula_of_time(prm.get("Torque"), obstacle + "/Torque");
    spring = prm.get_double("Spring");
  }

  double mass() const override { return inertia; }
  double turn() const override { return 1.; }
  double load(const double time, const FreeObstacle &then) const override
  {
    return torque({time}) - spring * then.way;
  }

private:
  double inertia = 0., spring = 0.;
  Expression torque{"0", {"t"}};
};

[[maybe_unused]] const bool registered =
    Registry<ObstacleDrive>::instance().add("torque",
                                            "a torque and what it meets turn it about 'Pivot'",
                                            [] { return std::make_unique<TorqueDrive>(); });
