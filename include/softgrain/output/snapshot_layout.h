// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_snapshot_layout_h
#define softgrain_output_snapshot_layout_h

#include <softgrain/analysis/snapshot.h>

#include <string>

namespace softgrain
{
class Hdf5File;

/// Writes a snapshot in the layout of doc/output.md to @p group of @p file, with a slash at its end; empty:
/// to its root, with units. Without @p points the material points are left out.
void write_snapshot(Hdf5File &file, const Snapshot<2> &snapshot, bool points, const std::string &group = "");

/// Reads it back bit for bit; @p group is where it is, with a slash at its end.
/// @throw InputError when something is missing or damaged.
Snapshot<2> read_snapshot_group(const Hdf5File &file, const std::string &group);
} // namespace softgrain

#endif
