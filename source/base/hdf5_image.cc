// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/hdf5_image.h>

#include <hdf5.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace softgrain
{
std::int64_t create_hdf5_image(const std::string &path)
{
  constexpr std::size_t growth = std::size_t(1) << 20;
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  hid_t file = -1;
  if (access >= 0 && H5Pset_fapl_core(access, growth, 0) >= 0)
    file = H5Fcreate((path + " in memory").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (access >= 0)
    H5Pclose(access);
  return file;
}

Hdf5Image hdf5_image(const std::int64_t file, const std::string &path)
{
  // Asked for without a place to copy to, HDF5 tells the size; flushed, its memory has all of that.
  const ssize_t size = H5Fflush(file, H5F_SCOPE_GLOBAL) < 0 ? -1 : H5Fget_file_image(file, nullptr, 0);
  void *memory = nullptr;
  if (size <= 0 || H5Fget_vfd_handle(file, H5P_DEFAULT, &memory) < 0 || memory == nullptr ||
      *static_cast<char **>(memory) == nullptr)
    throw ComputationError("cannot write " + path + ": HDF5 does not give its content");
  return {*static_cast<char **>(memory), static_cast<std::size_t>(size)};
}

void write_hdf5_image(const std::int64_t file, const std::string &path)
{
  const Hdf5Image image = hdf5_image(file, path);
  write_bytes(path, image.bytes, image.size);
}

void write_bytes(const std::string &path,
                 const void *bytes,
                 const std::size_t n_bytes,
                 const std::string &tail)
{
  const auto fail = [&path](const int reason)
  { throw ComputationError("cannot write " + path + ": " + std::strerror(reason)); };
  std::FILE *const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr)
    fail(errno);
  const bool whole = (n_bytes == 0 || std::fwrite(bytes, 1, n_bytes, file) == n_bytes) &&
                     (tail.empty() || std::fwrite(tail.data(), 1, tail.size(), file) == tail.size());
  const int reason = errno;
  // fclose writes what is still buffered, so a full disk may show only here.
  const bool closed = std::fclose(file) == 0;
  if (!whole || !closed)
    fail(whole ? errno : reason);
}
} // namespace softgrain
