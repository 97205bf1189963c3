// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/hdf5_disk_file.h>
#include <softgrain/output/hdf5_chunks.h>
#include <softgrain/output/hdf5_file.h>
#include <softgrain/output/hdf5_handle.h>
#include <softgrain/output/seal.h>

#include <hdf5.h>

#include <algorithm>
#include <memory>
#include <type_traits>

namespace softgrain
{
static_assert(std::is_same<hid_t, std::int64_t>::value, "the header keeps HDF5's handle as 64 bits");

namespace
{
/// An array without its numbers, to be closed.
hid_t create_set(const std::string &path,
                 const hid_t file,
                 const std::string &name,
                 const hid_t type,
                 const std::vector<hsize_t> &sizes,
                 const Hdf5Chunks *const chunks)
{
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose);
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false); // equal states give equal files
  if (chunks != nullptr)
    chunks->ask_for(creation);
  const hid_t set = H5Dcreate2(file, name.c_str(), type, space, links, creation, H5P_DEFAULT);
  if (set < 0)
    fail_to_write(path, name);
  return set;
}

void write_dataset(const std::string &path,
                   const hid_t file,
                   const std::string &name,
                   const hid_t type,
                   const std::vector<hsize_t> &sizes,
                   const void *values,
                   const unsigned int compression_level)
{
  const std::unique_ptr<Hdf5Chunks> chunks =
      compression_level > 0 && sizes[0] >= 256
          ? std::make_unique<Hdf5Chunks>(std::vector<std::uint64_t>(sizes.begin(), sizes.end()),
                                         H5Tget_size(type), compression_level)
          : nullptr;
  const Hdf5Handle set(create_set(path, file, name, type, sizes, chunks.get()), H5Dclose);
  const bool empty = std::find(sizes.begin(), sizes.end(), 0u) != sizes.end();
  if (!empty && !(chunks ? chunks->write(set, values)
                         : H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0))
    fail_to_write(path, name);
}

std::vector<std::uint64_t> shape(const std::size_t n_values, const unsigned int n_columns)
{
  if (n_columns == 1)
    return {n_values};
  return {n_values / n_columns, n_columns};
}

/// A part of an array of one column.
Hdf5Handle part_of(const hid_t set, const hsize_t begin, const hsize_t size)
{
  const hid_t space = H5Dget_space(set);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &size, nullptr);
  return Hdf5Handle(space, H5Sclose);
}

/// An open array with its type and length, after the checks every reading needs.
struct Source
{
  Source(const Hdf5File &owner,
         const std::string &path,
         const hid_t file,
         const std::string &name,
         const char expected)
      : set(owner.contains(name) ? H5Dopen2(file, name.c_str(), H5P_DEFAULT) : -1, H5Dclose)
      , type(set < 0 ? -1 : H5Dget_type(set), H5Tclose)
      , space(set < 0 ? -1 : H5Dget_space(set), H5Sclose)
  {
    if (!owner.contains(name))
      fail_to_read(path, name, "there is nothing of that name");
    if (set < 0 || type < 0 || space < 0)
      fail_to_read(path, name, "damaged" + hdf5_reason());
    if (kind_of_hdf5(type) != expected)
      fail_to_read(path, name,
                   std::string("it does not hold ") + (expected == 'd'   ? "numbers of double precision"
                                                       : expected == 'u' ? "integers"
                                                                         : "text"));
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    if (n < 0)
      fail_to_read(path, name, "damaged" + hdf5_reason());
    size = static_cast<std::size_t>(n);
  }

  void read(const std::string &path, const std::string &name, const hid_t memory_type, void *values) const
  {
    if (size > 0 && H5Dread(set, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
      fail_to_read(path, name, "damaged" + hdf5_reason());
  }

  Hdf5Handle set, type, space;
  std::size_t size = 0;
};

} // namespace

Hdf5File::Hdf5File(const std::string &path, const Mode mode, const unsigned int compression_level)
    : path(path), compression_level(compression_level)
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  if (mode == Mode::create)
  {
    disk = std::make_unique<Hdf5DiskFile>(path);
    file = disk->create();
    if (file < 0)
      fail_to_write(path, "");
  }
  else
  {
    file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0)
      throw InputError("cannot read " + path + " as an HDF5 file" + hdf5_reason());
  }
}

Hdf5File::~Hdf5File()
{
  if (file >= 0)
    H5Fclose(file);
}

void Hdf5File::close(const bool sealed)
{
  const hid_t closing = file;
  file = -1;
  if (H5Fclose(closing) < 0)
    fail_to_write(path, "");
  disk->finish();
  if (sealed)
    seal(path);
}

void Hdf5File::put(const std::string &name,
                   const std::int64_t type,
                   const std::vector<std::uint64_t> &sizes,
                   const void *const values,
                   const unsigned int level)
{
  write_dataset(path, file, name, type, {sizes.begin(), sizes.end()}, values, level);
  disk->check();
}

void Hdf5File::write(const std::string &name, const std::vector<double> &values, const unsigned int n_columns)
{
  put(name, H5T_NATIVE_DOUBLE, shape(values.size(), n_columns), values.data(), compression_level);
}

void Hdf5File::write(const std::string &name,
                     const std::vector<std::uint64_t> &values,
                     const unsigned int n_columns)
{
  put(name, H5T_NATIVE_UINT64, shape(values.size(), n_columns), values.data(), compression_level);
}

void Hdf5File::write(const std::string &name, const std::string &text)
{
  // One row of the text's length; no row when it is empty, for HDF5 has no strings of length zero.
  put(name, hdf5_text_type(text.size()), {text.empty() ? 0u : 1u}, text.data(), 0);
}

void Hdf5File::write(const std::string &name, const std::vector<std::string> &texts)
{
  std::size_t width = 1;
  for (const std::string &text : texts)
    width = std::max(width, text.size());
  std::string padded;
  for (const std::string &text : texts)
    padded += text + std::string(width - text.size(), '\0');
  put(name, hdf5_text_type(width), {texts.size()}, padded.data(), 0);
}

void Hdf5File::create_array(const std::string &name, const std::size_t size)
{
  const Hdf5Handle set(create_set(path, file, name, H5T_NATIVE_DOUBLE, {size}, nullptr), H5Dclose);
}

void Hdf5File::write_piece(const std::string &name,
                           const std::size_t begin,
                           const std::size_t size,
                           const double *const values)
{
  const Hdf5Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const hsize_t n = size;
  const Hdf5Handle here(H5Screate_simple(1, &n, nullptr), H5Sclose), there(part_of(set, begin, size));
  if (size > 0 && H5Dwrite(set, H5T_NATIVE_DOUBLE, here, there, H5P_DEFAULT, values) < 0)
    fail_to_write(path, name);
  disk->check();
}

std::vector<double> Hdf5File::read_doubles(const std::string &name) const
{
  const Source source(*this, path, file, name, 'd');
  std::vector<double> values(source.size);
  source.read(path, name, H5T_NATIVE_DOUBLE, values.data());
  return values;
}

void Hdf5File::read_piece(const std::string &name,
                          const std::size_t begin,
                          const std::size_t size,
                          double *const values) const
{
  const Source source(*this, path, file, name, 'd');
  const hsize_t n = size;
  const Hdf5Handle here(H5Screate_simple(1, &n, nullptr), H5Sclose), there(part_of(source.set, begin, size));
  if (size > 0 && H5Dread(source.set, H5T_NATIVE_DOUBLE, here, there, H5P_DEFAULT, values) < 0)
    fail_to_read(path, name, "damaged" + hdf5_reason());
}

std::size_t Hdf5File::size(const std::string &name) const
{
  return Source(*this, path, file, name, 'd').size;
}

std::vector<std::uint64_t> Hdf5File::read_integers(const std::string &name) const
{
  const Source source(*this, path, file, name, 'u');
  std::vector<std::uint64_t> values(source.size);
  source.read(path, name, H5T_NATIVE_UINT64, values.data());
  return values;
}

std::string Hdf5File::read_text(const std::string &name) const
{
  const Source source(*this, path, file, name, 't');
  std::string text(source.size * H5Tget_size(source.type), '\0');
  source.read(path, name, source.type, text.data());
  return text;
}

std::vector<std::string> Hdf5File::read_texts(const std::string &name) const
{
  const Source source(*this, path, file, name, 't');
  const std::size_t width = H5Tget_size(source.type);
  std::string padded(source.size * width, '\0');
  source.read(path, name, source.type, padded.data());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < source.size; ++i)
  {
    texts.push_back(padded.substr(i * width, width));
    texts.back().resize(texts.back().find_last_not_of('\0') + 1);
  }
  return texts;
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
  const Source source(*this, path, file, name, array_type(name));
  return source.size;
}
} // namespace softgrain
