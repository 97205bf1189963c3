// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_obstacle_drive_h
#define softgrain_scene_obstacle_drive_h

#include <softgrain/base/registry.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// How far an obstacle that is free has gone. Its way is in units of ObstacleDrive::shift() and turn().
struct FreeObstacle
{
  double way = 0;   ///< since the start
  double speed = 0; ///< [1/s]
};

/**
 * @brief What moves an obstacle beside the formulas of its place: `Obstacles/NAME/Drive` names a member of
 * this family.
 *
 * An obstacle that is free goes one way, which begins at 0: it is turned and shifted by so many times turn()
 * and shift(). What is done to it changes its speed, mass() d(speed)/dt = load() + force * shift() + torque *
 * turn(), where force and torque are those of the bodies on it, per metre of thickness in the plane. What it
 * feels in a step changes its speed at the end of that step: it goes the step with the speed that it has and
 * what its load adds.
 */
class ObstacleDrive
{
public:
  virtual ~ObstacleDrive() = default;

  /// Declares its parameters where the handler stands, in the section of an obstacle.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// @param obstacle "Obstacles/NAME", for messages. @throw InputError
  virtual void parse_parameters(const dealii::ParameterHandler &prm, const std::string &obstacle) = 0;

  /// Whether the obstacle is free; else the rest of this is not asked.
  virtual bool is_free() const { return true; }

  /// Inertia: of a turn by the angle a moment of inertia, of a shift by metres a mass; above 0.
  virtual double mass() const { return 1.; }

  /// Angle by which a unit of its way turns it about its pivot [rad].
  virtual double turn() const { return 0.; }
  /// Vector by which a unit of its way shifts it; in the plane the last component is not asked [m].
  virtual dealii::Tensor<1, 3> shift() const { return {}; }

  /// What acts along its way from outside: a torque of a turn, a force of a shift.
  virtual double load(double /*time*/, const FreeObstacle & /*then*/) const { return 0.; }
};

template <>
Registry<ObstacleDrive> &Registry<ObstacleDrive>::instance();

/// `Drive`, and what its members declare, where the handler stands.
void declare_obstacle_drive(dealii::ParameterHandler &prm);

/// @param obstacle "Obstacles/NAME", for messages
/// @throw InputError when something is set that belongs to another drive
std::shared_ptr<const ObstacleDrive> parse_obstacle_drive(const dealii::ParameterHandler &prm,
                                                          const std::string &obstacle);
} // namespace softgrain

#endif
