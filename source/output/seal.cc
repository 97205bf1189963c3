// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/seal.h>

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
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
} // namespace

std::string seal_of(const void *bytes, const std::size_t n_bytes)
{
  return seal_with(::crc32_z(::crc32_z(0, nullptr, 0), static_cast<const Bytef *>(bytes), n_bytes));
}

bool is_sealed(const std::string &path)
{
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff end = in.tellg(), n_seal = seal_with(0).size();
  if (!in || end <= n_seal)
    return false;
  in.seekg(0);
  uLong sum = ::crc32_z(0, nullptr, 0);
  std::vector<char> part(std::size_t(1) << 20);
  for (std::streamoff left = end - n_seal; left > 0;)
  {
    const std::streamoff n = std::min<std::streamoff>(left, part.size());
    if (!in.read(part.data(), n))
      return false;
    sum = ::crc32_z(sum, reinterpret_cast<const Bytef *>(part.data()), n);
    left -= n;
  }
  std::string seal(n_seal, '\0');
  return in.read(seal.data(), n_seal) && seal == seal_with(sum);
}
} // namespace softgrain
