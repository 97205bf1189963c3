// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_told_grid_h
#define softgrain_mpm_body_told_grid_h

#include <softgrain/mpm/body/body.h>

#include <vector>

namespace softgrain::mpm
{
/// What those without the points of a body are to know of its grid, number by number.
std::vector<double> tell_grid(const Body<2> &body);

/// Gives @p body what tell_grid() has told, as lay_grid() would have done.
void take_grid(const std::vector<double> &numbers,
               const Lattice<2> &lattice,
               const ShapeFunction &shape,
               Body<2> &body);
} // namespace softgrain::mpm

#endif
