// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_h
#define softgrain_driving_wall_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/driving/wall_parts.h>
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
 * In the plane forces, impulses, masses and works are per metre of thickness.
 */
template <int dim>
struct Wall
{
  static constexpr unsigned int no_body = static_cast<unsigned int>(-1);

  WallDescription<dim> description;
  unsigned int body = no_body; ///< slab of material points, if it is made of one
  double travel = 0;           ///< along the normal since the start [m]
  double speed = 0;            ///< along the normal; of a prescribed wall the mean over the last step [m/s]
  double slide_speed = 0;      ///< along the tangent; when prescribed the mean over the last step [m/s]
  double offset = 0;           ///< of the cell above, of a side of a cell that repeats [m]
  FreeMotion free;             ///< of a wall that is free
  DriveBegin driven_since;
  WallBook<dim> book;

  /// A point of its plane now [m].
  dealii::Point<dim> point() const { return description.point + travel * description.normal; }
  /// Unit, into the domain.
  const dealii::Tensor<1, dim> &normal() const { return description.normal; }
  dealii::Tensor<1, dim> tangent() const { return wall_tangent(normal()); }
  /// [m/s]
  dealii::Tensor<1, dim> velocity() const
  {
    return slide_speed == 0. ? speed * description.normal
                             : speed * description.normal + slide_speed * tangent();
  }

  bool prescribed() const { return description.drive->prescribed(); }
};

/// Whether a wall is a side of a cell that repeats.
template <int dim>
bool is_side_of_cell(const Wall<dim> &wall)
{
  return wall.description.type == WallDescription<dim>::Type::periodic;
}

/// Whether the velocity of a wall along its tangent follows from a shear stress.
template <int dim>
bool slides_freely(const Wall<dim> &wall)
{
  return wall.description.drive->shears();
}

/// The part of the velocity of a wall that is given [m/s].
dealii::Tensor<1, 2> prescribed_velocity_of(const Wall<2> &wall);

/// Gives a wall whose way is told the velocity that its drive asks for in a step of @p dt from @p time on
/// [s].
template <int dim>
void plan(Wall<dim> &wall, double time, double dt);

/**
 * @brief Puts the pressure that is asked for on a wall that is free, on a length or an area of @p size.
 *
 * What depends on the stress beside it is approached: in a packing that yields, that stress answers a change
 * of pressure with up to three times as much. It is approached from accept_pressure() to accept_pressure(),
 * so a step that is refused leaves nothing behind.
 *
 * @param share_of_damping of the damping that is chosen for the wall, what it gets; one that is given stays
 */
template <int dim>
void put_pressure(Wall<dim> &wall, double asked, double size, double share_of_damping = 1.);

/// Takes note that the step for which a wall was pressed was accepted.
inline void accept_pressure(Wall<2> &wall)
{
  wall.free.pressure_before = wall.free.pressure;
}

/// Puts the stress along the tangent that is asked for on a wall that is free to slide.
void put_shear(Wall<2> &wall, double asked, double length);

/// Energy of the motion of a wall that has a mass [J/m; J].
template <int dim>
double kinetic_energy_of(const Wall<dim> &wall);

/// What its drive asks of a wall in a step of @p dt from @p time on [s].
template <int dim>
WallDemand demand_of(const Wall<dim> &wall, double time, double dt, double stress_beside = 0.);

/// Velocity along the tangent that its drive asks of a wall in a step of @p dt from @p time on [m/s].
template <int dim>
double demanded_slide(const Wall<dim> &wall, double time, double dt);

/// Stress along the tangent that its drive asks of a wall in a step of @p dt from @p time on [Pa].
double demanded_shear(const Wall<2> &wall, double time, double dt);

/// What history, pictures and measures show of a wall.
template <int dim>
WallState<dim> state_of(const Wall<dim> &wall);

/// A wall that is free, as one unknown of a step: a given impulse P along its normal makes its velocity at
/// the end free_speed + P / mass.
struct FreeWallStep
{
  double mass = 0;       ///< with its damping [kg/m; kg]
  double free_speed = 0; ///< [m/s]
};

/// @param theta   weight of the velocity at the end in the motion over the step and in the damping
/// @param impulse what is known of the impulses on the wall beside its load, along the normal [N s/m]
template <int dim>
FreeWallStep free_wall_step(const Wall<dim> &wall, double dt, double theta, double impulse = 0.);

/// Step along the tangent of a wall that is free to slide.
FreeWallStep free_slide_step(const Wall<2> &wall, double dt, double theta, double impulse = 0.);

/// The walls of a scene at the start. Those that are free have the mass that is given, or a tenth of that of
/// all bodies.
template <int dim>
std::vector<Wall<dim>> make_walls(const Scene<dim> &scene);

/// Drives walls from @p time on as @p drives say, one per wall; null: as before.
/// @param inertia whether walls have kinetic energy: who holds a wall then gives it the energy of its motion,
/// and takes it, which is work
template <int dim>
void take_drives(std::vector<Wall<dim>> &walls,
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
template <int dim>
std::vector<WallState<dim>> states_of(const std::vector<Wall<dim>> &walls);

/// Length that a pressure on wall @p w acts on (2D): between the walls beside it, where they are now; 0
/// without them [m].
double pressed_length(const std::vector<Wall<2>> &walls, std::size_t w);

/// Mean of the stresses on the walls at right angles to wall @p w, which they felt in the last step (2D),
/// compression positive; 0 without them [Pa].
double stress_beside(const std::vector<Wall<2>> &walls, std::size_t w);

/// What the drive of the free wall @p w asks for [Pa].
inline double
asked_pressure(const std::vector<Wall<2>> &walls, const std::size_t w, const double time, const double dt)
{
  return demand_of(walls[w], time, dt, stress_beside(walls, w)).pressure;
}

/// A list of the numbers that make the state of walls, the same number for each.
template <int dim>
std::vector<double> numbers_of(const std::vector<Wall<dim>> &walls);
/// Takes such a list over.
template <int dim>
void take_numbers(const std::vector<double> &numbers, std::vector<Wall<dim>> &walls);
/// How many numbers numbers_of() has for a wall.
template <int dim>
constexpr std::size_t n_wall_numbers = dim == 2 ? 10 : 9;

/// Keeps walls under @p name in a checkpoint.
template <int dim>
void save_walls(StateWriter &out, const std::string &name, const std::vector<Wall<dim>> &walls);
/// @throw InputError when there were other walls
template <int dim>
void load_walls(const StateReader &in, const std::string &name, std::vector<Wall<dim>> &walls);
} // namespace softgrain

#endif
