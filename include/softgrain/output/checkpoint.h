// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_checkpoint_h
#define softgrain_output_checkpoint_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/model/state_file.h>
#include <softgrain/output/atomic_file.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
class Hdf5Reader;
class Hdf5Writer;

/**
 * @brief Writes a model's state to an HDF5 file that is whole or absent.
 *
 * Nothing is seen under the final name before commit(); destroying the writer without it discards everything,
 * and a file of that name from earlier stays as it was. Numbers are kept bit for bit. A list of contents says
 * what the file must hold.
 */
class CheckpointWriter : public StateWriter
{
public:
  /// @param final_path for example checkpoint_path(directory, step)
  explicit CheckpointWriter(const std::string &final_path);
  ~CheckpointWriter() override;

  void write(const std::string &name, const std::vector<double> &values) override;
  void write(const std::string &name, const std::vector<std::uint64_t> &values) override;
  void write(const std::string &name, const std::string &text) override;
  void write_rows(const std::string &name, std::size_t n_rows, std::size_t width, const Fill &fill) override;
  /// A whole snapshot, in a group of its own.
  template <int dim>
  void write_snapshot(const std::string &group, const Snapshot<dim> &snapshot);

  /**
   * @brief Seals the file with a checksum, brings it to the disk and renames it.
   * @throw ComputationError when the disk refuses.
   */
  void commit();

private:
  void note(const std::string &name, char type, std::size_t size);

  AtomicFile target;
  std::unique_ptr<Hdf5Writer> file;
  std::string contents; ///< a line for each list
};

/**
 * @brief Reads what a CheckpointWriter wrote. The constructor verifies the seal and that the file holds what
 * its list of contents says, so that a model never starts from half a state; sizes and numbers are looked at
 * as they are read.
 */
class CheckpointReader : public StateReader
{
public:
  /// @throw InputError that names the file: absent, not a checkpoint, incomplete, damaged, or of another
  /// version, which is named.
  explicit CheckpointReader(const std::string &path);
  ~CheckpointReader() override;

  bool contains(const std::string &name) const override;
  [[noreturn]] void refuse(const std::string &name, const std::string &why) const override;
  /// What write_snapshot() wrote.
  template <int dim>
  Snapshot<dim> read_snapshot(const std::string &group) const;

protected:
  std::size_t size(const std::string &name) const override;
  void rows(const std::string &name, std::size_t width, const Take &take) const override;
  std::vector<double> doubles(const std::string &name) const override;
  std::vector<std::uint64_t> integers(const std::string &name) const override;
  std::string text(const std::string &name) const override;

private:
  void read_contents();
  /// @throw InputError when the list of contents says another type or size
  void check_listed(const std::string &name, char type, std::size_t size) const;
  void check_finite(const std::string &name, const double *values, std::size_t n) const;

  std::string path;
  std::unique_ptr<Hdf5Reader> file;
  std::map<std::string, std::string> listed; ///< by name: type and size
};

/// `DIRECTORY/state-000001234.h5`
std::string checkpoint_path(const std::string &directory, std::uint64_t step);

/// The checkpoint that is kept of the end of a stage.
std::string stage_path(const std::string &directory, const std::string &stage);
/// Whether a file has the name of one.
bool is_stage_name(const std::string &name);

/**
 * @brief The newest whole checkpoint of a folder; damaged ones are passed over.
 * @throw InputError when there is none.
 */
std::string latest_checkpoint(const std::string &directory);

/// Whether a file has the name of a checkpoint.
bool is_checkpoint_name(const std::string &file_name);

/// Whether the file is a checkpoint of this or another version, whole or not.
bool is_checkpoint(const std::string &path);

/// Files of a folder that have the name of a checkpoint, the newest first.
std::vector<std::string> checkpoint_paths(const std::string &directory);

/// The checkpoint of a folder with the highest step, whole or not; nothing when there is none.
std::optional<std::string> newest_checkpoint(const std::string &directory);

/// Removes the checkpoints of a folder that are of a later step.
void remove_checkpoints_after(const std::string &directory, std::uint64_t step);

/// Removes all but the newest @p keep checkpoints of a folder; files that only have their name stay.
void remove_old_checkpoints(const std::string &directory, unsigned int keep);
} // namespace softgrain

#endif
