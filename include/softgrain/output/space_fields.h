// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_space_fields_h
#define softgrain_output_space_fields_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/output/vtu_file.h>

#include <vector>

/// What pictures of scenes in space show.
namespace softgrain::space_fields
{
/// Material points: body, volume, stress, von Mises stress, pressure and, if it is wanted, F.
void fill_points(VtuFile &file, const PointStates<3> &points, bool deformation_gradient, bool extra);

/// Bodies as triangles, with what belongs to a body on each.
void fill_surfaces(VtuFile &file, const std::vector<BodyState<3>> &bodies);

/// Places that carry force.
void fill_contacts(VtuFile &file, const std::vector<ContactState<3>> &contacts);

/// The sheets of obstacles, with where they are and what they feel.
void fill_obstacles(VtuFile &file, const std::vector<ObstacleState<3>> &obstacles);
} // namespace softgrain::space_fields

#endif
