// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_space_cell_h
#define softgrain_mpm_stepping_space_cell_h

#include <softgrain/mpm/stepping/slope_columns.h>

namespace softgrain
{
class SystemMatrix;
}

namespace softgrain::mpm
{
/**
 * @brief Stiffness of one cell in space over its independent nodes, without F-bar.
 *
 * The block of directions d and e is sum_ab G_a D_ab G_bᵀ over the points, with G_a the slopes of the nodes
 * along a and D_ab = v (C_daeb + δ_de τ_ab). Six such blocks, those with d <= e, are one product of small
 * matrices. Nodes are extended before it, point by point: a cell at the rim has few points.
 */
class SpaceCell
{
public:
  /// Adds the stiffness of a cell times @p factor to @p matrix.
  void
  add(const Body<3> &body, const StepState<3> &s, unsigned int cell, double factor, SystemMatrix &matrix);

private:
  SlopeColumns<3> slope_columns;
  CellMemory of_response, of_blocks;
};
} // namespace softgrain::mpm

#endif
