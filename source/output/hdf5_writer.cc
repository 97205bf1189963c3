// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/hdf5_disk_file.h>
#include <softgrain/output/hdf5_chunks.h>
#include <softgrain/output/hdf5_handle.h>
#include <softgrain/output/hdf5_writer.h>
#include <softgrain/output/seal.h>

#include <hdf5.h>

#include <algorithm>
#include <memory>

namespace softgrain
{
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

void put_attribute(const std::string &path,
                   const hid_t file,
                   const std::string &object,
                   const std::string &name,
                   const hid_t type,
                   const void *value)
{
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                               H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  if (attribute < 0 || H5Awrite(attribute, type, value) < 0)
    fail_to_write(path, object + "@" + name);
}
} // namespace

Hdf5Writer::Hdf5Writer(const std::string &path, const unsigned int compression_level)
    : Hdf5File(path), disk(std::make_unique<Hdf5DiskFile>(path)), compression_level(compression_level)
{
  file = disk->create();
  if (file < 0)
    fail_to_write(path, "");
}

/// A file that was not closed goes before what holds its disk.
Hdf5Writer::~Hdf5Writer()
{
  if (file >= 0)
    H5Fclose(file);
  file = -1;
}

void Hdf5Writer::close(const bool sealed)
{
  const hid_t closing = file;
  file = -1;
  if (H5Fclose(closing) < 0)
    fail_to_write(path, "");
  disk->finish();
  if (sealed)
    seal(path);
}

void Hdf5Writer::put(const std::string &name,
                     const std::int64_t type,
                     const std::vector<std::uint64_t> &sizes,
                     const void *const values,
                     const unsigned int level)
{
  write_dataset(path, file, name, type, {sizes.begin(), sizes.end()}, values, level);
  disk->check();
}

void Hdf5Writer::write(const std::string &name,
                       const std::vector<double> &values,
                       const unsigned int n_columns)
{
  put(name, H5T_NATIVE_DOUBLE, shape(values.size(), n_columns), values.data(), compression_level);
}

void Hdf5Writer::write(const std::string &name,
                       const std::vector<std::uint64_t> &values,
                       const unsigned int n_columns)
{
  put(name, H5T_NATIVE_UINT64, shape(values.size(), n_columns), values.data(), compression_level);
}

void Hdf5Writer::write(const std::string &name, const std::string &text)
{
  // One row of the text's length; no row when it is empty, for HDF5 has no strings of length zero.
  put(name, hdf5_text_type(text.size()), {text.empty() ? 0u : 1u}, text.data(), 0);
}

void Hdf5Writer::write(const std::string &name, const std::vector<std::string> &texts)
{
  std::size_t width = 1;
  for (const std::string &text : texts)
    width = std::max(width, text.size());
  std::string padded;
  for (const std::string &text : texts)
    padded += text + std::string(width - text.size(), '\0');
  put(name, hdf5_text_type(width), {texts.size()}, padded.data(), 0);
}

void Hdf5Writer::create_array(const std::string &name, const std::size_t size)
{
  const Hdf5Handle set(create_set(path, file, name, H5T_NATIVE_DOUBLE, {size}, nullptr), H5Dclose);
}

void Hdf5Writer::write_piece(const std::string &name,
                             const std::size_t begin,
                             const std::size_t size,
                             const double *const values)
{
  const Hdf5Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const hsize_t n = size;
  const Hdf5Handle here(H5Screate_simple(1, &n, nullptr), H5Sclose), there(hdf5_part(set, begin, size));
  if (size > 0 && H5Dwrite(set, H5T_NATIVE_DOUBLE, here, there, H5P_DEFAULT, values) < 0)
    fail_to_write(path, name);
  disk->check();
}

void Hdf5Writer::write_attribute(const std::string &object, const std::string &name, const double value)
{
  put_attribute(path, file, object, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5Writer::write_attribute(const std::string &object,
                                 const std::string &name,
                                 const std::uint64_t value)
{
  put_attribute(path, file, object, name, H5T_NATIVE_UINT64, &value);
}

void Hdf5Writer::write_attribute(const std::string &object, const std::string &name, const std::string &text)
{
  put_attribute(path, file, object, name, hdf5_text_type(text.size()), text.c_str());
}

void Hdf5Writer::link(const std::string &name, const std::string &target, const std::string &object)
{
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  if (H5Lcreate_external(target.c_str(), object.c_str(), file, name.c_str(), links, H5P_DEFAULT) < 0)
    fail_to_write(path, name);
}
} // namespace softgrain
