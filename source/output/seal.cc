// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/seal.h>

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <vector>

namespace softgrain
{
namespace
{
std::string seal_with(const unsigned long sum)
{
  char text[40];
  std::snprintf(text, sizeof(text), "\nsoftgrain seal %08lx\n", sum);
  return text;
}

/// The seal of the next @p n_bytes, as far as they can be read.
std::optional<std::string> seal_of(std::istream &in, std::streamoff n_bytes)
{
  uLong sum = ::crc32_z(0, nullptr, 0);
  std::vector<char> part(std::size_t(1) << 20);
  while (n_bytes > 0)
  {
    const std::streamoff n = std::min<std::streamoff>(n_bytes, part.size());
    if (!in.read(part.data(), n))
      return std::nullopt;
    sum = ::crc32_z(sum, reinterpret_cast<const Bytef *>(part.data()), n);
    n_bytes -= n;
  }
  return seal_with(sum);
}
} // namespace

void seal(const std::string &path)
{
  errno = 0;
  std::fstream file(path, std::ios::binary | std::ios::ate | std::ios::in | std::ios::out);
  const std::streamoff end = file.tellg();
  file.seekg(0);
  const std::optional<std::string> line = file ? seal_of(file, end) : std::nullopt;
  file.seekp(end);
  if (!line || !file.write(line->data(), line->size()).flush())
    throw ComputationError("cannot write " + path + ": " + std::strerror(errno != 0 ? errno : EIO));
}

bool is_sealed(const std::string &path)
{
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff end = in.tellg(), n_seal = seal_with(0).size();
  if (!in || end <= n_seal)
    return false;
  in.seekg(0);
  const std::optional<std::string> expected = seal_of(in, end - n_seal);
  std::string seal(n_seal, '\0');
  return expected && in.read(seal.data(), n_seal) && seal == *expected;
}
} // namespace softgrain
