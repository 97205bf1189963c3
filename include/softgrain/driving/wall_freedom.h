// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_wall_freedom_h
#define softgrain_driving_wall_freedom_h

#include <softgrain/driving/wall.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

/// @file
/// How the motion of a wall depends on what is done to it: along its tangent and along its normal it is
/// either told how to go, or free and loaded.

namespace softgrain
{
/// A direction in which a wall may be free.
enum class Freedom
{
  along, ///< its tangent, under a shear stress
  across ///< its normal, under a pressure
};

/// Whether loads and contacts say how a wall moves in a direction; else its drive does.
template <int dim>
bool is_free(const WallDescription<dim> &wall, const Freedom direction)
{
  return direction == Freedom::along ? wall.drive->shears() : !wall.drive->prescribed();
}
template <int dim>
bool is_free(const Wall<dim> &wall, const Freedom direction)
{
  return is_free(wall.description, direction);
}
/// Whether that is so in any direction.
bool is_free(const Wall<2> &wall);
/// The directions in which a wall is free, the tangent first.
std::vector<Freedom> freedoms_of(const Wall<2> &wall);

/// Unit vector.
dealii::Tensor<1, 2> way_of(const Wall<2> &wall, Freedom direction);
/// What is put on it that way, and what resists it.
const WallLoad &load_on(const Wall<2> &wall, Freedom direction);
/// That way [m/s].
double &speed_of(Wall<2> &wall, Freedom direction);
double speed_of(const Wall<2> &wall, Freedom direction);

/// Stress on wall @p w that its drive asks for in a step of @p dt from @p time on [Pa].
double
asked_stress(const std::vector<Wall<2>> &walls, std::size_t w, Freedom direction, double time, double dt);
/// Puts that stress on it. @param share_of_damping see put_pressure()
void put_stress(std::vector<Wall<2>> &walls,
                std::size_t w,
                Freedom direction,
                double time,
                double dt,
                double share_of_damping = 1.);

/// The step of a wall as one unknown, see FreeWallStep.
FreeWallStep free_step(const Wall<2> &wall, Freedom direction, double dt, double theta, double impulse = 0.);

/// How a wall goes over a step if nothing touches it, and what an impulse changes: of a direction in which it
/// is told how to go, nothing, as its mass is infinite there.
struct WallAhead
{
  FreeWallStep along, across;

  dealii::Tensor<1, 2> velocity(const Wall<2> &wall) const; ///< [m/s]
};
/// @param theta see free_wall_step()
WallAhead ahead_of(const Wall<2> &wall, double dt, double theta);

/// Velocities along the normal and the tangent [m/s].
struct WallRates
{
  double speed = 0.;
  double slide = 0.;
};
/// What its drive tells a wall for a step of @p dt from @p time on; 0 where it is free.
WallRates told_rates(const Wall<2> &wall, double time, double dt);
/// What its drive tells it; where it is free, as it goes now.
WallRates expected_rates(const Wall<2> &wall, double time, double dt);

/// Whether bodies meet it; through a side of a cell that repeats they go.
template <int dim>
bool is_met(const Wall<dim> &wall)
{
  return !is_side_of_cell(wall);
}

/// Whether bodies meet its plane itself: it is neither made of material points nor a side of a cell.
template <int dim>
bool is_plane(const Wall<dim> &wall)
{
  return wall.body == Wall<dim>::no_body && !is_side_of_cell(wall);
}

/// Calls work(wall), or work(wall, number), for the walls that are sides of a cell that repeats.
template <class Walls, class Work>
void for_sides(Walls &walls, const Work &work)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (is_side_of_cell(walls[w]))
    {
      if constexpr (std::is_invocable_v<const Work &, decltype(walls[w]), std::size_t>)
        work(walls[w], w);
      else
        work(walls[w]);
    }
}

/// Calls work(wall, number) for the walls that bodies meet.
template <class Walls, class Work>
void for_met(Walls &walls, const Work &work)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (is_met(walls[w]))
      work(walls[w], w);
}

/// Calls work(number, body) for the walls that are made of material points.
template <class Work>
void for_slabs(const std::vector<Wall<2>> &walls, const Work &work)
{
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (walls[w].body != Wall<2>::no_body)
      work(w, walls[w].body);
}

/// Whether there are such walls.
template <int dim>
bool any_sides(const std::vector<Wall<dim>> &walls)
{
  return std::any_of(walls.begin(), walls.end(), is_side_of_cell<dim>);
}
} // namespace softgrain

#endif
