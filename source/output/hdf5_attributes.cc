// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Hdf5File with attributes and links, and what it shares with that of arrays.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_file.h>
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

namespace
{
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

void Hdf5File::write_attribute(const std::string &object, const std::string &name, const double value)
{
  put_attribute(path, file, object, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5File::write_attribute(const std::string &object, const std::string &name, const std::uint64_t value)
{
  put_attribute(path, file, object, name, H5T_NATIVE_UINT64, &value);
}

void Hdf5File::write_attribute(const std::string &object, const std::string &name, const std::string &text)
{
  put_attribute(path, file, object, name, hdf5_text_type(text.size()), text.c_str());
}

double Hdf5File::read_double_attribute(const std::string &object, const std::string &name) const
{
  return number_from<double>(get_attribute(path, file, object, name, 'd'));
}

std::uint64_t Hdf5File::read_integer_attribute(const std::string &object, const std::string &name) const
{
  return number_from<std::uint64_t>(get_attribute(path, file, object, name, 'u'));
}

std::string Hdf5File::read_text_attribute(const std::string &object, const std::string &name) const
{
  std::string text = get_attribute(path, file, object, name, 't');
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

bool Hdf5File::has_attribute(const std::string &object, const std::string &name) const
{
  return H5Aexists_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5File::link(const std::string &name, const std::string &target, const std::string &object)
{
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  if (H5Lcreate_external(target.c_str(), object.c_str(), file, name.c_str(), links, H5P_DEFAULT) < 0)
    fail_to_write(path, name);
}

} // namespace softgrain
