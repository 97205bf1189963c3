// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_space_points_h
#define softgrain_mpm_model_space_points_h

#include <softgrain/mpm/body/body.h>

#include <vector>

namespace softgrain::mpm
{
/// Whether the points of a body remember what they went through. All else follows from the nodes.
bool remembers(const Body<3> &body);

/// What they remember, one point after the other: stress and history.
std::vector<double> remembered_by_points(const std::vector<Body<3>> &bodies);

/// Gives points what remembered_by_points() has told of them.
void take_points(const std::vector<double> &remembered, std::vector<Body<3>> &bodies);
} // namespace softgrain::mpm

#endif
