// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_handle.h>

#include <algorithm>

namespace softgrain
{
std::string hdf5_reason()
{
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned int, const H5E_error2_t *error, void *data) -> herr_t
      {
        std::string &first = *static_cast<std::string *>(data);
        if (first.empty() && error->desc != nullptr)
          first = error->desc;
        return 0;
      },
      &text);
  H5Eclear2(H5E_DEFAULT);
  return text.empty() ? "" : ": " + text;
}

void fail_to_write(const std::string &path, const std::string &name)
{
  throw ComputationError("cannot write " + (name.empty() ? "" : "'" + name + "' to ") + path + hdf5_reason());
}

void fail_to_read(const std::string &path, const std::string &name, const std::string &why)
{
  throw InputError("cannot read '" + name + "' from " + path + ": " + why);
}

Hdf5Handle hdf5_text_type(const std::size_t size)
{
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max<std::size_t>(size, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return Hdf5Handle(type, H5Tclose);
}

char kind_of_hdf5(const hid_t type)
{
  const std::size_t size = H5Tget_size(type);
  switch (H5Tget_class(type))
  {
  case H5T_FLOAT:
    return size == 8 ? 'd' : '?';
  case H5T_INTEGER:
    return size == 8 ? 'u' : '?';
  case H5T_STRING:
    return H5Tis_variable_str(type) > 0 ? '?' : 't';
  default:
    return '?';
  }
}

Hdf5Handle hdf5_part(const hid_t set, const hsize_t begin, const hsize_t size)
{
  const hid_t space = H5Dget_space(set);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &size, nullptr);
  return Hdf5Handle(space, H5Sclose);
}
} // namespace softgrain
