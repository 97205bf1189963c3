// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_file.h>
#include <softgrain/output/hdf5_handle.h>

#include <hdf5.h>

#include <type_traits>

namespace softgrain
{
static_assert(std::is_same<hid_t, std::int64_t>::value, "the header keeps HDF5's handle as 64 bits");

Hdf5File::Hdf5File(const std::string &path) : path(path)
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5File::~Hdf5File()
{
  if (file >= 0)
    H5Fclose(file);
}

bool Hdf5File::contains(const std::string &name) const
{
  // HDF5 wants every group on the way asked for in turn.
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1))
  {
    if (H5Lexists(file, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
      return false;
    if (end == std::string::npos)
      return true;
  }
}

std::vector<std::string> Hdf5File::array_names() const
{
  std::vector<std::string> names;
#if H5_VERSION_GE(1, 12, 0)
  using Info = H5O_info2_t;
#else
  using Info = H5O_info_t;
#endif
  const auto visit = [](hid_t, const char *name, const Info *info, void *data) -> herr_t
  {
    if (info->type == H5O_TYPE_DATASET)
      static_cast<std::vector<std::string> *>(data)->push_back(name);
    return 0;
  };
#if H5_VERSION_GE(1, 12, 0)
  const herr_t done = H5Ovisit3(file, H5_INDEX_NAME, H5_ITER_INC, visit, &names, H5O_INFO_BASIC);
#else
  const herr_t done = H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, visit, &names);
#endif
  if (done < 0)
    throw InputError("cannot list what is in " + path + hdf5_reason());
  return names;
}

char Hdf5File::array_type(const std::string &name) const
{
  const Hdf5Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (set < 0)
    fail_to_read(path, name, "damaged" + hdf5_reason());
  return kind_of_hdf5(Hdf5Handle(H5Dget_type(set), H5Tclose));
}

std::size_t Hdf5File::array_size(const std::string &name) const
{
  const Hdf5Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(set < 0 ? -1 : H5Dget_space(set), H5Sclose);
  const hssize_t n = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
  if (n < 0)
    fail_to_read(path, name, "damaged" + hdf5_reason());
  return static_cast<std::size_t>(n);
}
} // namespace softgrain
