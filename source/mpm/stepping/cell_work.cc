// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/cell_work.h>

namespace softgrain::mpm
{
template <int dim>
CellWork<dim>
measure_against_cell(const CellMotion<dim> &cell, const double dt, std::vector<Body<dim>> &bodies)
{
  const MeasuredAgain<dim> again(cell, dt);
  CellWork<dim> done;
  for (Body<dim> &body : bodies)
  {
    const double mass = body.nodes.mass.sum();
    const dealii::Tensor<1, dim> momentum = body.nodes.momentum(), change = again.change(mass, momentum);
    for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        body.nodes.velocity[dim * i + d] += change[d];
    done.impulse += mass * change;
    done.work += (momentum + 0.5 * mass * change) * change;
  }
  return done;
}

template CellWork<2> measure_against_cell(const CellMotion<2> &, double, std::vector<Body<2>> &);
template CellWork<3> measure_against_cell(const CellMotion<3> &, double, std::vector<Body<3>> &);
} // namespace softgrain::mpm
