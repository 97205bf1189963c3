// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_h
#define softgrain_driving_wall_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/geometry/wall_tangent.h>
#include <softgrain/scene/scene.h>
#include <softgrain/scene/wall_drive.h>

#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/**
 * @brief A wall on its way: where it is, how it moves and what it has felt; the same in every model.
 *
 * Forces are those of the bodies on the wall, impulses those of the wall on the bodies, per metre of
 * thickness.
 */
struct Wall
{
  static constexpr unsigned int no_body = static_cast<unsigned int>(-1);

  WallDescription<2> description;
  unsigned int body = no_body;  ///< slab of material points, if it is made of one
  double travel = 0;            ///< along the normal since the start [m]
  double speed = 0;             ///< along the normal; of a prescribed wall the mean over the last step [m/s]
  double pressure = 0;          ///< on a wall that is free [Pa]
  double pressure_before = 0;   ///< the same in the last step that was accepted [Pa]
  double load = 0;              ///< force along the normal from outside, of a wall that is free [N/m]
  double mass = 0;              ///< of a wall that is free [kg/m]
  double usual_mass = 0;        ///< the same if none is given [kg/m]
  double drive_begin = 0;       ///< since when it is driven as it is [s]
  double travel_before = 0;     ///< until then [m]
  double slide_speed = 0;       ///< along the tangent; when prescribed the mean over the last step [m/s]
  double slide_load = 0;        ///< force along the tangent from outside, of a wall free to slide [N/m]
  double slide_mass = 0;        ///< of a wall that is free to slide [kg/m]
  double slide_damping = 0;     ///< of it, as damping [kg/(m s)]
  double offset = 0;            ///< of the cell above, of a side of a cell that repeats [m]
  double damping = 0;           ///< force against its motion, per velocity, under its load [kg/(m s)]
  dealii::Tensor<1, 2> force;   ///< on the wall, mean over the last step [N/m]
  dealii::Tensor<1, 2> impulse; ///< given to the bodies since the start [N s/m]
  /// Done since the start by what drives it: a wall of prescribed velocity, or the load on a free one [J/m].
  double work = 0;

  /// A point of its plane now [m].
  dealii::Point<2> point() const { return description.point + travel * description.normal; }
  /// Unit, into the domain.
  const dealii::Tensor<1, 2> &normal() const { return description.normal; }
  dealii::Tensor<1, 2> tangent() const { return wall_tangent(normal()); }
  /// [m/s]
  dealii::Tensor<1, 2> velocity() const
  {
    return slide_speed == 0. ? speed * description.normal
                             : speed * description.normal + slide_speed * tangent();
  }

  /// Whether it is a side of a cell that repeats.
  bool repeats() const { return description.type == WallDescription<2>::Type::periodic; }

  bool prescribed() const { return description.drive->prescribed(); }
  /// Whether its velocity along the tangent follows from a shear stress.
  bool slides_freely() const { return description.drive->shears(); }
  /// The part of its velocity that is given [m/s].
  dealii::Tensor<1, 2> prescribed_velocity() const
  {
    return (prescribed() ? speed : 0.) * description.normal +
           (slides_freely() ? 0. : slide_speed) * tangent();
  }

  /**
   * @brief Puts the pressure that is asked for on a wall that is free, on a length of @p length.
   *
   * What depends on the stress beside it is approached: in a packing that yields, that stress answers a
   * change of pressure with up to three times as much. It is approached from accept_pressure() to
   * accept_pressure(), so a step that is refused leaves nothing behind.
   *
   * @param share_of_damping of the damping that is chosen for the wall, what it gets; one that is given stays
   */
  void press(double asked, double length, double share_of_damping = 1.);

  /// Takes note that the step for which it was pressed was accepted.
  void accept_pressure() { pressure_before = pressure; }

  /// Puts the stress along the tangent that is asked for on a wall that is free to slide.
  void shear(double asked, double length);

  /// [J/m]
  double kinetic_energy() const
  {
    return 0.5 * (mass * speed * speed + slide_mass * slide_speed * slide_speed);
  }

  /// What its drive asks of it in a step of @p dt from @p time on [s].
  WallDemand demand(const double time, const double dt, const double stress_beside = 0.) const
  {
    return description.drive->demand({time - drive_begin, dt, travel - travel_before, stress_beside});
  }

  /// Velocity along the tangent that its drive asks of it in a step of @p dt from @p time on [m/s].
  double demanded_slide(const double time, const double dt) const
  {
    return description.drive->slides()
               ? description.drive->slide_velocity({time - drive_begin, dt, travel - travel_before})
               : 0.;
  }

  /// Stress along the tangent that its drive asks of it in a step of @p dt from @p time on [Pa].
  double demanded_shear(const double time, const double dt) const
  {
    return description.drive->shear_stress({time - drive_begin, dt, travel - travel_before});
  }

  /// Books an impulse that the wall has given to the bodies in a step of @p dt [s].
  void give(const dealii::Tensor<1, 2> &given, const double dt)
  {
    force -= given / dt;
    impulse += given;
  }

  /// What history, pictures and measures show of it.
  WallState<2> state() const;
};

/// A wall that is free, as one unknown of a step: a given impulse P along its normal makes its velocity at
/// the end free_speed + P / mass.
struct FreeWallStep
{
  double mass = 0;       ///< with its damping [kg/m]
  double free_speed = 0; ///< [m/s]
};

/// @param theta   weight of the velocity at the end in the motion over the step and in the damping
/// @param impulse what is known of the impulses on the wall beside its load, along the normal [N s/m]
FreeWallStep free_wall_step(const Wall &wall, double dt, double theta, double impulse = 0.);

/// Step along the tangent of a wall that is free to slide.
FreeWallStep free_slide_step(const Wall &wall, double dt, double theta, double impulse = 0.);

/// The walls of a scene at the start. Those that are free have the mass that is given, or a tenth of that of
/// all bodies.
std::vector<Wall> make_walls(const Scene<2> &scene);

/// Drives walls from @p time on as @p drives say, one per wall; null: as before.
/// @param inertia whether walls have kinetic energy: who holds a wall then gives it the energy of its motion,
/// and takes it, which is work
void take_drives(std::vector<Wall> &walls,
                 const std::vector<std::shared_ptr<const WallDrive>> &drives,
                 double time,
                 bool inertia = true);

/// Whether the pressure of a free wall has a length to act on.
/// @throw InputError
void check_free_walls(const Scene<2> &scene);

/// Whether walls that move along their tangent take something with them, and sides of a cell go together.
/// @throw InputError
void check_sliding_walls(const Scene<2> &scene);

/// What the models report of all walls.
std::vector<WallState<2>> states_of(const std::vector<Wall> &walls);

/// Length that a pressure on wall @p w acts on (2D): between the walls beside it, where they are now; 0
/// without them [m].
double pressed_length(const std::vector<Wall> &walls, std::size_t w);

/// Mean of the stresses on the walls at right angles to wall @p w, which they felt in the last step (2D),
/// compression positive; 0 without them [Pa].
double stress_beside(const std::vector<Wall> &walls, std::size_t w);

/// What the drive of the free wall @p w asks for [Pa].
inline double
asked_pressure(const std::vector<Wall> &walls, const std::size_t w, const double time, const double dt)
{
  return walls[w].demand(time, dt, stress_beside(walls, w)).pressure;
}

/// Keeps walls under @p name in a checkpoint.
void save_walls(StateWriter &out, const std::string &name, const std::vector<Wall> &walls);
/// @throw InputError when there were other walls
void load_walls(const StateReader &in, const std::string &name, std::vector<Wall> &walls);
} // namespace softgrain

#endif
