// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_hdf5_image_h
#define softgrain_base_hdf5_image_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace softgrain
{
/**
 * @brief Makes an HDF5 file that is kept in memory; the caller closes it with H5Fclose.
 *
 * When a disk refuses what HDF5 writes, HDF5 keeps the file open and crashes at the end of the program. So
 * HDF5 writes to memory, and write_hdf5_image() brings the bytes to the disk.
 * @param path where it will go: HDF5 tells open files apart by their names
 * @return HDF5's handle, negative when there is no memory
 */
std::int64_t create_hdf5_image(const std::string &path);

/// The bytes of a file in memory.
struct Hdf5Image
{
  const char *bytes;
  std::size_t size;
};

/// All bytes of the file in memory, where HDF5 has them: until the next call of HDF5. @p path is for the
/// message. @throw ComputationError
Hdf5Image hdf5_image(std::int64_t file, const std::string &path);

/// Writes everything the file in memory holds to @p path. @throw ComputationError with the reason of the
/// system.
void write_hdf5_image(std::int64_t file, const std::string &path);

/// Replaces @p path by these bytes, with @p tail behind them. @throw ComputationError "cannot write PATH:
/// REASON"
void write_bytes(const std::string &path,
                 const void *bytes,
                 std::size_t n_bytes,
                 const std::string &tail = std::string());
} // namespace softgrain

#endif
