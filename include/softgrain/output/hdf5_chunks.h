// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_hdf5_chunks_h
#define softgrain_output_hdf5_chunks_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace softgrain
{
/**
 * @brief Compressed chunks of one array of an HDF5 file, made on all threads.
 *
 * HDF5 itself compresses on one thread, and that is most of the time a snapshot takes. What stands in the
 * file is the same: its filters shuffle and deflate read it.
 */
class Hdf5Chunks
{
public:
  /**
   * @param sizes of the array; cut along the first
   * @param width bytes of a value
   * @param compression_level 1 to 9; more is 9
   */
  Hdf5Chunks(std::vector<std::uint64_t> sizes, std::size_t width, unsigned int compression_level);

  /// Sets chunks and filters of the array to be made, an HDF5 property list.
  void ask_for(std::int64_t creation) const;

  /// Compresses @p values and hands them to the array @p set. @return whether HDF5 took them.
  bool write(std::int64_t set, const void *values) const;

private:
  std::vector<unsigned char> compress(std::size_t chunk, const char *values) const;

  std::vector<std::uint64_t> sizes, chunk;
  std::size_t width, row_bytes;
  int level;
};
} // namespace softgrain

#endif
