// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_snapshot_outlines_h
#define softgrain_output_snapshot_outlines_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/output/snapshot_rows.h>

#include <string>
#include <vector>

namespace softgrain
{
/// Lines around bodies in the plane, `outlines`, and their surfaces in space, `surfaces`.
void write_outlines(const snapshot_rows::Hdf5Group &file, const std::vector<BodyState<2>> &bodies);
void write_outlines(const snapshot_rows::Hdf5Group &file, const std::vector<BodyState<3>> &bodies);

/// Both ways back. @throw InputError when offsets do not fit
void read_outlines(const Hdf5Reader &file, const std::string &group, std::vector<BodyState<2>> &bodies);
void read_outlines(const Hdf5Reader &file, const std::string &group, std::vector<BodyState<3>> &bodies);

/// Lines of obstacles in the plane, and their sheets in space.
void write_lines(const snapshot_rows::Hdf5Group &file, const std::vector<ObstacleState<2>> &obstacles);
void write_lines(const snapshot_rows::Hdf5Group &file, const std::vector<ObstacleState<3>> &obstacles);
void read_lines(const Hdf5Reader &file, const std::string &group, std::vector<ObstacleState<2>> &obstacles);
void read_lines(const Hdf5Reader &file, const std::string &group, std::vector<ObstacleState<3>> &obstacles);
} // namespace softgrain

#endif
