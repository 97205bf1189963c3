// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
double Opening::share(const Body<2> &body, const double dt) const
{
  if (length == 0.)
    return 1.;
  const double crossed = dt * std::sqrt(body.law->young_modulus() / body.density) / length;
  return std::min(1., crossed * crossed);
}

std::vector<double> row_velocity(const State &state,
                                 const Workspace &work,
                                 const std::vector<Eigen::VectorXd> &v,
                                 const std::vector<WallMotion<2>> &motion,
                                 const std::vector<double> &start_relative,
                                 const double theta,
                                 const double dt,
                                 const Opening &opening,
                                 const bool with_impulses)
{
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  std::vector<double> q = work.contact.relative_velocity(work.share, state.bodies, work.drive, v);
  const std::optional<CellMotion> cell = state.cell_motion(motion);
  dealii::Tensor<2, 2> at_start, at_end;
  if (cell)
  {
    CellMotion first = *cell, last = *cell;
    for (const FreeWall<2> &free : work.contact.free_walls.list)
      if (state.walls[free.wall].repeats())
      {
        const double mean = free.slides() ? motion[free.wall].slide : motion[free.wall].velocity;
        first.add_side(free.normal, (free.start_speed - mean) * free.way);
        last.add_side(free.normal, ((with_impulses ? free.speed : free.free_speed) - mean) * free.way);
      }
    at_start = first.gradient;
    at_end = last.gradient;
  }
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    // Slabs that are driven move in relative_velocity() already.
    const bool plane = rows[r].partner == ContactRow<2>::none && !rows[r].obstacle;
    double start = plane ? motion[rows[r].wall].velocity : 0., end = start;
    if (rows[r].obstacle)
    {
      start = end = rows[r].partner_velocity * rows[r].normal;
      for (unsigned int c = 1; c < components; ++c)
        q[r * components + c] -= rows[r].partner_velocity * rows[r].direction(c);
    }
    if (plane && motion[rows[r].wall].slide != 0. && !state.walls[rows[r].wall].slides_freely())
      for (unsigned int c = 1; c < components; ++c)
        q[r * components + c] -=
            motion[rows[r].wall].slide * (motion[rows[r].wall].tangent() * rows[r].direction(c));
    for (const FreeWall<2> &free : work.contact.free_walls.list)
      if (free.wall == rows[r].wall)
      {
        const double moves = with_impulses ? free.speed : free.free_speed;
        for (unsigned int c = 1; c < components; ++c)
          q[r * components + c] -= moves * (free.way * rows[r].direction(c));
        // Of a slab both may have a part along the normal of a row; a plane has but the first.
        start = (free.slides() ? start : 0.) + free.start_speed * (free.way * rows[r].normal);
        end = (free.slides() ? end : 0.) + moves * (free.way * rows[r].normal);
      }
    if (cell)
    {
      // The cell takes the bodies along: what parts them so is known, or as fast as free sides move.
      start -= at_start * rows[r].branch * rows[r].direction(0);
      end -= at_end * rows[r].branch * rows[r].direction(0);
      for (unsigned int c = 1; c < components; ++c)
        q[r * components + c] += at_end * rows[r].branch * rows[r].direction(c);
    }
    q[r * components] -= end;
    double predicted = rows[r].gap;
    if (opening.opens && predicted < 0.)
      predicted *= opening.share(state.bodies[rows[r].body], dt);
    if (theta < 1.)
      predicted += (1. - theta) * dt * (start_relative[r * components] - start);
    if (predicted > 0. || opening.opens)
      q[r * components] += predicted / (theta * dt);
  }
  return q;
}
} // namespace softgrain::mpm
