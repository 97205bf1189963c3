// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/free_way.h>

#include <cmath>
#include <limits>

namespace softgrain::mpm
{
template <int dim>
FreeWay<dim>::FreeWay(const FreeWall<dim> &free,
                      const unsigned int slab,
                      const PeriodicCell<dim> *repeats,
                      const double net,
                      const double load,
                      const double limit,
                      const double stiffness)
    : stopped(net > 0.   ? 1
              : net < 0. ? -1
                         : 0)
    , load(load)
    , stiffness(stiffness)
    , limit(limit)
    , wall(free.wall)
    , slab(slab)
    , way(free.way)
{
  if (repeats == nullptr)
    return;
  cell.emplace();
  cell->cell = *repeats;
  cell->add_side(free.normal, free.way);
}

template <int dim>
FreeWay<dim> FreeWay<dim>::with_mass(const FreeWall<dim> &free,
                                     const unsigned int slab,
                                     const PeriodicCell<dim> *cell,
                                     const double theta,
                                     const double dt)
{
  const double begun = (1. - theta) * free.start_speed, stiffness = free.mass / (theta * dt * dt),
               farthest = free.stop > 0. ? dt * (std::abs(begun) + theta * free.stop)
                                         : std::numeric_limits<double>::max();
  FreeWay way(free, slab, cell, 0., stiffness * dt * (begun + theta * free.free_speed), farthest, stiffness);
  way.at = dt * free.start_speed;
  return way;
}

template <int dim>
std::array<typename FreeWay<dim>::Vector, 2> FreeWay<dim>::moves(const FrameScene<dim> &scene,
                                                                 const FrameState<dim> &frame) const
{
  std::array<Vector, 2> result;
  const ContactFrame<dim> &layout = frame.layout();
  const bool at_wall = layout.partner == FrameState<dim>::none;
  if (at_wall && layout.wall == wall)
    result[0] = way;
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = frame.body(side); b != FrameState<dim>::none)
    {
      if (b == slab)
        result[side] = way;
      else if (cell && !scene.bodies[b].rigid.driven)
        result[side] = cell->velocity(scene.bodies[b].center());
    }
  if (cell)
    result[0] += cell->gradient * frame.image_shift();
  return result;
}

template struct FreeWay<2>;
template struct FreeWay<3>;
} // namespace softgrain::mpm
