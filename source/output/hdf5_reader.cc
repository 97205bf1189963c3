// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_handle.h>
#include <softgrain/output/hdf5_reader.h>

#include <hdf5.h>

#include <algorithm>

namespace softgrain
{
namespace
{
/// An open array with its type and length, after the checks every reading needs.
struct Source
{
  Source(const Hdf5Reader &owner,
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

std::string get_attribute(const std::string &path,
                          const hid_t file,
                          const std::string &object,
                          const std::string &name,
                          const char expected)
{
  const std::string full = object + "@" + name;
  const Hdf5Handle attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  if (attribute < 0)
    fail_to_read(path, full, "there is no such attribute" + hdf5_reason());
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (kind_of_hdf5(type) != expected || H5Sget_simple_extent_npoints(space) != 1)
    fail_to_read(path, full, "it has another type");
  std::string bytes(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, bytes.data()) < 0)
    fail_to_read(path, full, "damaged" + hdf5_reason());
  return bytes;
}

template <typename Number>
Number number_from(const std::string &bytes)
{
  Number number;
  std::copy(bytes.begin(), bytes.begin() + sizeof(Number), reinterpret_cast<char *>(&number));
  return number;
}
} // namespace

Hdf5Reader::Hdf5Reader(const std::string &path) : Hdf5File(path)
{
  file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file < 0)
    throw InputError("cannot read " + path + " as an HDF5 file" + hdf5_reason());
}

std::vector<double> Hdf5Reader::read_doubles(const std::string &name) const
{
  const Source source(*this, path, file, name, 'd');
  std::vector<double> values(source.size);
  source.read(path, name, H5T_NATIVE_DOUBLE, values.data());
  return values;
}

void Hdf5Reader::read_piece(const std::string &name,
                            const std::size_t begin,
                            const std::size_t size,
                            double *const values) const
{
  const Source source(*this, path, file, name, 'd');
  const hsize_t n = size;
  const Hdf5Handle here(H5Screate_simple(1, &n, nullptr), H5Sclose),
      there(hdf5_part(source.set, begin, size));
  if (size > 0 && H5Dread(source.set, H5T_NATIVE_DOUBLE, here, there, H5P_DEFAULT, values) < 0)
    fail_to_read(path, name, "damaged" + hdf5_reason());
}

std::size_t Hdf5Reader::size(const std::string &name) const
{
  return Source(*this, path, file, name, 'd').size;
}

std::vector<std::uint64_t> Hdf5Reader::read_integers(const std::string &name) const
{
  const Source source(*this, path, file, name, 'u');
  std::vector<std::uint64_t> values(source.size);
  source.read(path, name, H5T_NATIVE_UINT64, values.data());
  return values;
}

std::string Hdf5Reader::read_text(const std::string &name) const
{
  const Source source(*this, path, file, name, 't');
  std::string text(source.size * H5Tget_size(source.type), '\0');
  source.read(path, name, source.type, text.data());
  return text;
}

std::vector<std::string> Hdf5Reader::read_texts(const std::string &name) const
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

double Hdf5Reader::read_double_attribute(const std::string &object, const std::string &name) const
{
  return number_from<double>(get_attribute(path, file, object, name, 'd'));
}

std::uint64_t Hdf5Reader::read_integer_attribute(const std::string &object, const std::string &name) const
{
  return number_from<std::uint64_t>(get_attribute(path, file, object, name, 'u'));
}

std::string Hdf5Reader::read_text_attribute(const std::string &object, const std::string &name) const
{
  std::string text = get_attribute(path, file, object, name, 't');
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

bool Hdf5Reader::has_attribute(const std::string &object, const std::string &name) const
{
  return H5Aexists_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}
} // namespace softgrain
