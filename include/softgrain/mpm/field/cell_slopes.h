// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_cell_slopes_h
#define softgrain_mpm_field_cell_slopes_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>
#include <softgrain/mpm/field/lattice_box.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>

namespace softgrain::mpm
{
/// One slope per node of a cell, in place: the loops over points make one after the other.
template <int dim>
using CellSlopes =
    boost::container::static_vector<dealii::Tensor<1, dim>, power(ShapeFunction::max_nodes, dim)>;

/// Slopes in the trial configuration at point @p p; small-strain laws stay with those of the grid.
template <int dim>
void current_slopes(const Body<dim> &body,
                    const StepState<dim> &s,
                    const unsigned int p,
                    CellSlopes<dim> &slopes)
{
  const dealii::Tensor<1, dim> *slope = body.field.at_point(p).slopes;
  slopes.resize(body.field.cells().nodes_per_cell());
  if (body.material.small_strain())
    std::copy(slope, slope + slopes.size(), slopes.begin());
  else
  {
    const dealii::Tensor<2, dim> inverse = invert(s.grid_gradient[p]);
    for (unsigned int k = 0; k < slopes.size(); ++k)
      slopes[k] = slope[k] * inverse;
  }
}

/// Mean over a cell of the current slopes, weighted with current volume, and that volume: F-bar's dilatation.
template <int dim>
double
mean_slopes(const Body<dim> &body, const StepState<dim> &s, const unsigned int cell, CellSlopes<dim> &mean)
{
  mean.assign(body.field.cells().nodes_per_cell(), dealii::Tensor<1, dim>());
  CellSlopes<dim> slopes;
  double total = 0.;
  for (unsigned int p = body.field.cells().first_point(cell); p < body.field.cells().first_point(cell + 1);
       ++p)
  {
    current_slopes(body, s, p, slopes);
    const auto point = body.points[p];
    // F holds the mean dilatation here, so the weight needs the determinant of what really happened.
    const double weight =
        body.material.small_strain()
            ? s.volume[p]
            : point.rest_volume() * determinant(s.grid_gradient[p]) * determinant(point.gradient());
    total += weight;
    for (unsigned int k = 0; k < mean.size(); ++k)
      mean[k] += weight * slopes[k];
  }
  for (auto &slope : mean)
    slope /= total;
  return total;
}
} // namespace softgrain::mpm

#endif
