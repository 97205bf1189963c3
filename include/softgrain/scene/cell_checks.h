// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_cell_checks_h
#define softgrain_scene_cell_checks_h

#include <softgrain/geometry/periodic_cell.h>
#include <softgrain/scene/scene.h>

/// @file
/// Whether walls that are sides of a cell that repeats make one, in the plane and in space.

namespace softgrain
{
/// Whether a wall is a side of a cell that repeats.
template <int dim>
bool repeats(const WallDescription<dim> &wall)
{
  return wall.type == WallDescription<dim>::Type::periodic;
}

/// The cell between the walls of a scene at its start.
template <int dim>
PeriodicCell<dim> cell_of(const Scene<dim> &scene);

/// Sides of a cell come in pairs, along the axes, and nothing but planes at right angles stands beside them.
/// @throw InputError
template <int dim>
void check_sides(const std::vector<WallDescription<dim>> &walls);

/// A cell is wide enough for its bodies not to meet themselves, and has no obstacles. @throw InputError
template <int dim>
void check_cell(const Scene<dim> &scene);

/// Refuses loads that see velocities: in a cell that repeats a body is at many places, and its velocity is
/// that beside the motion of the cell. @throw InputError
template <int dim>
void check_loads_in_cell(const Scene<dim> &scene);

/// Only the sides at bottom and top of a cell that repeats along x, too, may go along their tangent, and of
/// two that face each other one may be free. @throw InputError
template <int dim>
void check_motion_of_sides(const std::vector<WallDescription<dim>> &walls);

/// What a wall that goes along its tangent is told by: "Tangential velocity", or a stress.
template <int dim>
std::string tangential_key(const WallDescription<dim> &wall);
} // namespace softgrain

#endif
