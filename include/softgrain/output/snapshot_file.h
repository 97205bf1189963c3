// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_snapshot_file_h
#define softgrain_output_snapshot_file_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/output/late_files.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace softgrain
{
/// What of a snapshot is kept for analysis.
struct SnapshotOptions
{
  bool points = true;                 ///< off: bodies, outlines, contacts, walls and energies only
  unsigned int compression_level = 1; ///< of HDF5's deflate filter, 0 to 9
};

/**
 * @brief Keeps snapshots in `snapshots.h5`, in full precision, for analysis.
 *
 * Each snapshot is a file of its own, `snapshots/NNNNNN.h5`, and `snapshots.h5` is an index whose groups
 * `/steps/NNNNNN` are HDF5 links to them: both appear whole or not at all, so a run may be stopped at any
 * moment without loss, and readers (h5py, this library) see one file. doc/output.md gives the layout.
 */
class SnapshotFile
{
public:
  /// @param directory the output folder; made when missing
  explicit SnapshotFile(const std::string &directory, const SnapshotOptions &options = SnapshotOptions());

  /// Goes on with the series in the folder: keeps snapshots up to @p time [s], drops later ones.
  void resume(double time);

  /// Adds one; snapshots at this time or later are replaced by it. @throw ComputationError when the disk
  /// refuses.
  template <int dim>
  void append(const Snapshot<dim> &snapshot);

  /// Waits for the disk to have all that were added. @throw ComputationError when it refuses.
  void bring_to_disk() { late.bring_to_disk(); }

  std::size_t n_snapshots() const { return entries.size(); }

private:
  struct Entry
  {
    double time = 0;
    std::uint64_t step = 0;
  };

  void write_index();
  void remove_stale_files() const;

  std::string directory;
  SnapshotOptions options;
  std::vector<Entry> entries;
  LateFiles late;
  bool stale_files_removed = false;
};

/// Times of the snapshots in a `snapshots.h5` [s]. @throw InputError when it cannot be read.
std::vector<double> snapshot_times(const std::string &path);

/// Whether the snapshots in a `snapshots.h5` are of the plane, 2, or of space, 3; 2 of one without any.
unsigned int dimension_of_snapshots(const std::string &path);

/// Snapshot number @p index of a `snapshots.h5`, as it was written, bit for bit.
/// @throw InputError when it cannot be read, or is of another dimension.
template <int dim = 2>
Snapshot<dim> read_snapshot(const std::string &path, std::size_t index);

/// Removes the snapshots of a run from its output folder, and nothing else.
void remove_snapshots(const std::string &directory);
} // namespace softgrain

#endif
