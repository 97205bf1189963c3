// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_box_measures_h
#define softgrain_analysis_box_measures_h

#include <softgrain/analysis/snapshot.h>

#include <optional>
#include <vector>

namespace softgrain
{
/// ln(h0/h) of the distance of bottom and top; nothing without these walls.
std::optional<double> axial_strain(const std::vector<WallState<2>> &start,
                                   const std::vector<WallState<2>> &now);

/// @p solid_area over the area of the box; nothing unless bottom, top, left and right are there.
std::optional<double> packing_fraction(const std::vector<WallState<2>> &walls, double solid_area);
} // namespace softgrain

#endif
