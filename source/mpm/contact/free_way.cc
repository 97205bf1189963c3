// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/free_way.h>

namespace softgrain::mpm
{
FreeWay::FreeWay(const FreeWall<2> &free,
                 const unsigned int slab,
                 const PeriodicCell<2> *repeats,
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

std::array<FreeWay::Vector, 2> FreeWay::moves(const FrameScene &scene, const FrameState &frame) const
{
  std::array<Vector, 2> result;
  const ContactFrame<2> &layout = frame.layout();
  const bool at_wall = layout.partner == FrameState::none;
  if (at_wall && layout.wall == wall)
    result[0] = way;
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = frame.body(side); b != FrameState::none)
    {
      if (b == slab)
        result[side] = way;
      else if (cell && !scene.bodies[b].driven)
        result[side] = cell->velocity(scene.bodies[b].center());
    }
  if (cell)
    result[0] += cell->gradient * frame.image_shift();
  return result;
}
} // namespace softgrain::mpm
