// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_wall_drive_h
#define softgrain_scene_wall_drive_h

#include <softgrain/base/expression.h>
#include <softgrain/base/registry.h>

#include <memory>
#include <optional>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// The step for which a drive is asked.
struct WallStep
{
  double begin = 0;  ///< [s]
  double dt = 0;     ///< [s]
  double travel = 0; ///< of the wall along its normal until begin [m]
  double stress_beside =
      0; ///< mean on the walls at right angles to it, compression positive, last known [Pa]

  double middle() const { return begin + 0.5 * dt; } ///< [s]
};

/// What a drive asks of its wall in a step.
struct WallDemand
{
  double velocity = 0; ///< mean over the step, along the normal; of a prescribed wall [m/s]
  double pressure = 0; ///< mean over the step, towards the bodies; of a wall that is free to move [Pa]
};

/// What resists the motion of a wall that is free to move; nothing where the program is to choose.
struct WallInertia
{
  std::optional<double> mass;    ///< [kg/m in 2D]
  std::optional<double> damping; ///< force per velocity [kg/(m s) in 2D]
};

/**
 * @brief How a wall is driven: `Walls/NAME/Drive` names a member of this family.
 *
 * A prescribed wall has the velocity of demand(), from which a position that is asked for follows with the
 * step and the travel so far. A wall that is not prescribed has a velocity of its own, one more unknown of
 * the step, which follows from the pressure, its inertia and the contacts.
 */
class WallDrive
{
public:
  virtual ~WallDrive() = default;

  /// Declares its parameters where the handler stands, in the section of a wall.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// @param wall "Walls/NAME", for messages. @throw InputError
  virtual void parse_parameters(const dealii::ParameterHandler &prm, const std::string &wall) = 0;

  /// Whether the velocity of the wall is given.
  virtual bool prescribed() const = 0;

  virtual WallDemand demand(const WallStep &step) const = 0;

  /// Whether the pressure it asks for depends on the stress beside it.
  virtual bool looks_beside() const { return false; }

  /// Inertia of a wall that is not prescribed.
  virtual WallInertia inertia() const { return {}; }

  /// Moves the wall along its tangent too, whatever moves it along its normal. @param formula of t [m/s]
  void slide(const Expression &formula) { sliding = formula; }
  bool slides() const { return sliding.has_value(); }
  /// Velocity along the tangent, mean over the step [m/s].
  double slide_velocity(const WallStep &step) const { return sliding ? (*sliding)({step.middle()}) : 0.; }

  /// Frees the wall to move along its tangent under a stress, in place of slide(). @param formula of t [Pa]
  void shear(const Expression &formula) { shearing = formula; }
  bool shears() const { return shearing.has_value(); }
  /// Shear stress on the length of the wall, mean over the step [Pa].
  double shear_stress(const WallStep &step) const { return shearing ? (*shearing)({step.middle()}) : 0.; }

private:
  std::optional<Expression> sliding, shearing;
};

template <>
Registry<WallDrive> &Registry<WallDrive>::instance();

/// A drive with its parameters at their defaults, but for those given as "Key=value"; for walls @p wall that
/// no parameter file describes.
std::shared_ptr<const WallDrive>
make_drive(const std::string &name, const std::string &wall, const std::vector<std::string> &parameters = {});
} // namespace softgrain

#endif
