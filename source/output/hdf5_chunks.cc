// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/output/hdf5_chunks.h>

#include <hdf5.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace softgrain
{
namespace
{
/// Rows of a chunk: enough chunks for all threads in an array of some ten thousand.
constexpr std::uint64_t rows_of_a_chunk = 1u << 13;
} // namespace

Hdf5Chunks::Hdf5Chunks(std::vector<std::uint64_t> array_sizes,
                       const std::size_t value_width,
                       const unsigned int compression_level)
    : sizes(std::move(array_sizes))
    , chunk(sizes)
    , width(value_width)
    , row_bytes(value_width)
    , level(static_cast<int>(std::min(compression_level, 9u)))
{
  chunk[0] = std::min(chunk[0], rows_of_a_chunk);
  for (std::size_t d = 1; d < sizes.size(); ++d)
    row_bytes *= sizes[d];
}

void Hdf5Chunks::ask_for(const std::int64_t creation) const
{
  const std::vector<hsize_t> shape(chunk.begin(), chunk.end());
  H5Pset_chunk(creation, static_cast<int>(shape.size()), shape.data());
  H5Pset_shuffle(creation); // bytes of equal weight side by side: this is what makes doubles shrink
  H5Pset_deflate(creation, static_cast<unsigned int>(level));
}

std::vector<unsigned char> Hdf5Chunks::compress(const std::size_t c, const char *values) const
{
  const std::size_t first = c * chunk[0], last = std::min<std::size_t>(first + chunk[0], sizes[0]);
  std::vector<unsigned char> bytes(chunk[0] * row_bytes, 0); // the last chunk is filled up
  std::memcpy(bytes.data(), values + first * row_bytes, (last - first) * row_bytes);
  // First bytes of all values, second bytes, …
  std::vector<unsigned char> shuffled(bytes.size());
  const std::size_t n = bytes.size() / width;
  for (std::size_t byte = 0; byte < width; ++byte)
    for (std::size_t i = 0; i < n; ++i)
      shuffled[byte * n + i] = bytes[i * width + byte];
  uLongf size = ::compressBound(shuffled.size());
  std::vector<unsigned char> packed(size);
  if (::compress2(packed.data(), &size, shuffled.data(), shuffled.size(), level) != Z_OK)
    size = 0;
  packed.resize(size);
  return packed;
}

bool Hdf5Chunks::write(const std::int64_t set, const void *values) const
{
  const std::size_t n_chunks = (sizes[0] + chunk[0] - 1) / chunk[0];
  std::vector<std::vector<unsigned char>> packed(n_chunks);
  parallel_for(n_chunks, 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t c = begin; c < end; ++c)
                   packed[c] = compress(c, static_cast<const char *>(values));
               });
  std::vector<hsize_t> offset(sizes.size(), 0);
  for (std::size_t c = 0; c < n_chunks; ++c)
  {
    offset[0] = c * chunk[0];
    if (packed[c].empty() ||
        H5Dwrite_chunk(set, H5P_DEFAULT, 0, offset.data(), packed[c].size(), packed[c].data()) < 0)
      return false;
  }
  return true;
}
} // namespace softgrain
