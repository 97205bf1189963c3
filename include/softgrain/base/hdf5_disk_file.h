// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_hdf5_disk_file_h
#define softgrain_base_hdf5_disk_file_h

#include <cstdint>
#include <memory>
#include <string>

namespace softgrain
{
/**
 * @brief A place on the disk where HDF5 makes a file, whatever the disk does.
 *
 * When a disk refuses what HDF5 writes, HDF5 keeps the file open and crashes at the end of the program. So
 * HDF5 writes through this, and never hears of it: from the first refusal on nothing is written any more, and
 * check() and finish() tell. After that the file is only to be closed. What is written is on the disk at
 * once, so the file may be larger than the memory.
 */
class Hdf5DiskFile
{
public:
  /// Replaces what is at @p path. @throw ComputationError "cannot write PATH: REASON"
  explicit Hdf5DiskFile(const std::string &path);
  /// The file of HDF5 must be closed before.
  ~Hdf5DiskFile();
  Hdf5DiskFile(const Hdf5DiskFile &) = delete;
  Hdf5DiskFile &operator=(const Hdf5DiskFile &) = delete;

  /// Makes the file, once; the caller closes it with H5Fclose. @return HDF5's handle, negative when there is
  /// no memory
  std::int64_t create();

  /// @throw ComputationError "cannot write PATH: REASON" when the disk has refused something
  void check() const;

  /// Closes the file when HDF5 has closed its own, and checks.
  void finish();

  struct Disk; ///< what HDF5 writes to

private:
  std::string path;
  std::unique_ptr<Disk> disk;
};
} // namespace softgrain

#endif
