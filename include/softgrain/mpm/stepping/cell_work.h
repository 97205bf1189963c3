// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_cell_work_h
#define softgrain_mpm_stepping_cell_work_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/mpm/body/body.h>

#include <vector>

namespace softgrain::mpm
{
/// What a cell that deforms does to bodies beside the work of its sides, see CellMotion.
template <int dim>
struct CellWork
{
  dealii::Tensor<1, dim> impulse; ///< [N s/m; N s in space]
  double work = 0;                ///< [J/m; J in space]
};

/// Ends a step of @p dt in which the cell deformed: velocities become those beside that of the cell as it is
/// now, so that its copies stay alike.
template <int dim>
CellWork<dim> measure_against_cell(const CellMotion<dim> &cell, double dt, std::vector<Body<dim>> &bodies);
} // namespace softgrain::mpm

#endif
