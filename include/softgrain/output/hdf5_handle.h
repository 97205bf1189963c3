// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_hdf5_handle_h
#define softgrain_output_hdf5_handle_h

#include <hdf5.h>

#include <cstddef>
#include <string>

namespace softgrain
{
/// An HDF5 object that is closed at the end of the block.
class Hdf5Handle
{
public:
  Hdf5Handle(const hid_t id, herr_t (*const close)(hid_t)) : id(id), close(close) {}
  ~Hdf5Handle()
  {
    if (id >= 0)
      close(id);
  }
  Hdf5Handle(const Hdf5Handle &) = delete;
  Hdf5Handle &operator=(const Hdf5Handle &) = delete;
  operator hid_t() const { return id; }

private:
  hid_t id;
  herr_t (*close)(hid_t);
};

/// What HDF5 says of its last error, innermost first: the reason of the system, such as a full disk. It is
/// forgotten then.
std::string hdf5_reason();

[[noreturn]] void fail_to_write(const std::string &path, const std::string &name);
[[noreturn]] void fail_to_read(const std::string &path, const std::string &name, const std::string &why);

/// Type of texts of @p size bytes.
Hdf5Handle hdf5_text_type(std::size_t size);

/// A part of an array of one column, to be read or written.
Hdf5Handle hdf5_part(hid_t set, hsize_t begin, hsize_t size);

/// 'd' double, 'u' unsigned integer, 't' text, '?' another.
char kind_of_hdf5(hid_t type);
} // namespace softgrain

#endif
