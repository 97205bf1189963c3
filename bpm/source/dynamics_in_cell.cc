// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that knows of a cell that repeats.
#include <softgrain/bpm/dynamics.h>

namespace softgrain::bpm
{
namespace
{
dealii::Tensor<1, 2> velocity_of(const Wall<2> &side, std::size_t)
{
  return side.velocity();
}
} // namespace

void Dynamics::see_cell(const std::vector<Wall<2>> &walls)
{
  cell.reset();
  if (!any_sides(walls))
    return;
  cell = motion_of(cell_of(walls), walls, velocity_of);
  find_centers();
}

contact::ImageLattice Dynamics::lattice() const
{
  if (!cell)
    return {};
  const PeriodicCell<2> &here = cell->cell;
  return {here.periodic, {{here.lower[0], here.lower[1]}}, here.length, here.offset};
}

void Dynamics::find_centers()
{
  const std::size_t n_bodies = primaries.size() == 0 ? 0 : primaries.body.back() + 1;
  center_of_body.assign(n_bodies, dealii::Point<2>());
  mass_of_body.assign(n_bodies, 0.);
  for (std::size_t i = 0; i < primaries.size(); ++i)
  {
    mass_of_body[primaries.body[i]] += primaries.mass[i];
    for (unsigned int d = 0; d < 2; ++d)
      center_of_body[primaries.body[i]][d] += primaries.mass[i] * primaries.position[i][d];
  }
  for (std::size_t b = 0; b < n_bodies; ++b)
    center_of_body[b] /= mass_of_body[b];
}

dealii::Tensor<1, 2>
Dynamics::branch(const std::uint32_t a, const std::uint32_t b, const PeriodicCell<2>::Image &image) const
{
  if (primaries.body[a] == primaries.body[b])
    return {};
  return center_of_body[primaries.body[a]] - center_of_body[primaries.body[b]] - cell->cell.shift(image);
}

void Dynamics::prepare_cell(const double dt, const std::vector<Wall<2>> &walls)
{
  cell = motion_of(cell_of(walls), walls, velocity_of);
  bodies.cell = contact::DiskCell();
  for_sides(walls,
            [&](const Wall<2> &side)
            {
              const unsigned int d = axis_of(side.normal());
              const double length = cell->cell.length[d];
              for (const Freedom direction : {Freedom::across, Freedom::along})
                if (is_free(side, direction))
                {
                  const FreeWallStep step = free_step(side, direction, dt, 1.);
                  cell->add_side(side.normal(),
                                 (step.free_speed - speed_of(side, direction)) * way_of(side, direction));
                  bodies.cell.inverse_mass[direction == Freedom::across ? d : 1 - d][d] =
                      1. / (step.mass * length * length);
                }
            });
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int l = 0; l < 2; ++l)
      bodies.cell.gradient[k][l] = cell->gradient[k][l];
}

void Dynamics::load_cell(const double dt, std::vector<Wall<2>> &walls, std::vector<double> &impulse)
{
  dealii::Tensor<2, 2> virial;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const std::array<double, 2> &n = rows.normal[row], &r = rows.branch[row];
    const double t = rotations ? rows.tangential_impulse[row] : 0.;
    const double force[2] = {(n[0] * rows.impulse[row] - n[1] * t) / dt,
                             (n[1] * rows.impulse[row] + n[0] * t) / dt};
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
        virial[k][l] += force[k] * r[l];
  }
  load_sides(walls, cell->cell, virial);
  for_sides(walls,
            [&](const Wall<2> &side, const std::size_t w)
            {
              impulse[w] = -dt * (side.book.force * side.normal());
              dealii::Tensor<1, 2> velocity;
              for (const Freedom direction : freedoms_of(side))
                velocity +=
                    free_step(side, direction, dt, 1., dt * (side.book.force * way_of(side, direction)))
                        .free_speed *
                    way_of(side, direction);
              for (unsigned int d = 0; d < 2; ++d)
                bodies.velocity[primaries.size() + w][d] = velocity[d];
            });
}

void Dynamics::take_along(const double dt, std::vector<Wall<2>> &walls, DynamicsReport &report)
{
  // Sides have their speeds at the end of the step, and their places at its start.
  const CellMotion<2> motion = motion_of(cell->cell, walls, velocity_of);
  const double offset = motion.offset_after(dt);
  for_sides(walls, [&](Wall<2> &side) { side.offset = offset; });
  if (!motion.deforms())
    return;
  const MeasuredAgain<2> again(motion, dt);
  std::vector<dealii::Tensor<1, 2>> way(center_of_body.size()), change(center_of_body.size());
  for (std::size_t i = 0; i < primaries.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      change[primaries.body[i]][d] += primaries.mass[i] * primaries.velocity[i][d];
  for (std::size_t b = 0; b < way.size(); ++b)
  {
    way[b] = dt * motion.velocity(center_of_body[b]);
    change[b] = again.change(mass_of_body[b], change[b]);
    report.cell_impulse += mass_of_body[b] * change[b];
  }
  for (std::size_t i = 0; i < primaries.size(); ++i)
  {
    const std::uint32_t b = primaries.body[i];
    for (unsigned int d = 0; d < 2; ++d)
    {
      primaries.position[i][d] += way[b][d];
      report.cell_work += primaries.mass[i] * change[b][d] * (primaries.velocity[i][d] + 0.5 * change[b][d]);
      primaries.velocity[i][d] += change[b][d];
    }
  }
  report.wall_work += report.cell_work;
}
} // namespace softgrain::bpm
