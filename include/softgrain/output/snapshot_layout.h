// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_snapshot_layout_h
#define softgrain_output_snapshot_layout_h

#include <softgrain/analysis/snapshot.h>

#include <string>

namespace softgrain
{
class Hdf5Reader;
class Hdf5Writer;

/// Writes a snapshot in the layout of doc/output.md to @p group of @p file, with a slash at its end; empty:
/// to its root, with units. Without @p points the material points are left out.
template <int dim>
void write_snapshot(Hdf5Writer &file,
                    const Snapshot<dim> &snapshot,
                    bool points,
                    const std::string &group = "");

/// 2 or 3. @param group where a snapshot is, with a slash at its end
unsigned int dimension_of_snapshot(const Hdf5Reader &file, const std::string &group);

/// Reads it back bit for bit; @p group is where it is, with a slash at its end.
/// @throw InputError when something is missing or damaged, or it is of another dimension.
template <int dim>
Snapshot<dim> read_snapshot_group(const Hdf5Reader &file, const std::string &group);
} // namespace softgrain

#endif
