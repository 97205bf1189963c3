// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_remembered_points_h
#define softgrain_mpm_body_remembered_points_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/body_share.h>

#include <vector>

/// @file
/// What points of bodies in space remember of what they went through.

namespace softgrain::mpm
{
/// Whether the points of a body remember what they went through. All else follows from the nodes.
bool remembers(const Body<3> &body);

/// What they remember, one point after the other: stress and history.
std::vector<double> remembered_by_points(const std::vector<Body<3>> &bodies);

/// Gives points what remembered_by_points() has told of them.
void take_points(const std::vector<double> &remembered, std::vector<Body<3>> &bodies);

/// Lets all ranks know what the points of owned bodies remember.
void share_points(const BodyShare &share, std::vector<Body<3>> &bodies);
} // namespace softgrain::mpm

#endif
