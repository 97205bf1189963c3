// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_pressed_walls_h
#define softgrain_mpm_stepping_pressed_walls_h

#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/stepping/step.h>

#include <vector>

namespace softgrain::mpm
{
/// The direction in which it is free.
inline Freedom freedom_of(const FreeWall<2> &wall)
{
  return wall.slides() ? Freedom::along : Freedom::across;
}

/// Puts their loads on the walls that are free and makes them unknowns of the step.
void press_walls(const Problem &problem, State &state, Workspace &work, const StepPlan &plan);

/// Writes into @p motion where free walls go under the present impulses.
void follow_free_walls(const Problem &problem, const Workspace &work, std::vector<WallMotion<2>> &motion);

/// Settles the free walls when the step is found; slabs go with their walls.
void settle_free_walls(const Problem &problem,
                       const State &state,
                       Workspace &work,
                       std::vector<WallMotion<2>> &motion);

/// Books the work of the load of a free wall over a step, what its damping and the scheme take, and its speed
/// at the end.
void account_free_wall(const Problem &problem, State &state, const FreeWall<2> &free, double rate, double dt);

/// Largest difference of the force on a free wall from its load, over the load or, where that is less, over
/// the smallest force that counts (dimensionless); `quasi_static`.
double unbalanced_walls(const Problem &problem, const State &state);

/// The wall with that difference and what acts on it, in words; empty when all are in balance.
std::string least_balanced_wall(const Problem &problem, const State &state);

/// Whether a free wall went as far as its stop in the last step.
bool walls_are_on_their_way(const Workspace &work);

/// The way of the last step of the walls that slide freely, if they went as far as their stop; else 0 [m].
double slid_on_their_way(const Workspace &work, double dt);

/// @param slid the sum of slid_on_their_way() since balance was lost [m]
/// @throw ComputationError when a free wall has left the room in which it could meet anything
void check_room_of_walls(const Problem &problem, const State &state, double slid);
} // namespace softgrain::mpm

#endif
