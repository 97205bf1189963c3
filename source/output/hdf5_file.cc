// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/hdf5_image.h>
#include <softgrain/output/hdf5_chunks.h>
#include <softgrain/output/hdf5_file.h>
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
/// An HDF5 object that is closed at the end of the block.
class Handle
{
public:
  Handle(const hid_t id, herr_t (*const close)(hid_t)) : id(id), close(close) {}
  ~Handle()
  {
    if (id >= 0)
      close(id);
  }
  Handle(const Handle &) = delete;
  Handle &operator=(const Handle &) = delete;
  operator hid_t() const { return id; }

private:
  hid_t id;
  herr_t (*close)(hid_t);
};

/// What HDF5 says of its last error, innermost first: the reason of the system, such as a full disk.
std::string reason()
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

[[noreturn]] void fail_to_write(const std::string &path, const std::string &name)
{
  throw ComputationError("cannot write " + (name.empty() ? "" : "'" + name + "' to ") + path + reason());
}

[[noreturn]] void fail_to_read(const std::string &path, const std::string &name, const std::string &why)
{
  throw InputError("cannot read '" + name + "' from " + path + ": " + why);
}

Handle text_type(const std::size_t size)
{
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max<std::size_t>(size, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return Handle(type, H5Tclose);
}

void write_dataset(const std::string &path,
                   const hid_t file,
                   const std::string &name,
                   const hid_t type,
                   const std::vector<hsize_t> &sizes,
                   const void *values,
                   const unsigned int compression_level)
{
  const Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const std::unique_ptr<Hdf5Chunks> chunks =
      compression_level > 0 && sizes[0] >= 256
          ? std::make_unique<Hdf5Chunks>(std::vector<std::uint64_t>(sizes.begin(), sizes.end()),
                                         H5Tget_size(type), compression_level)
          : nullptr;
  if (chunks)
    chunks->ask_for(creation);
  const Handle set(H5Dcreate2(file, name.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose);
  if (set < 0)
    fail_to_write(path, name);
  const bool empty = std::find(sizes.begin(), sizes.end(), 0u) != sizes.end();
  if (!empty && !(chunks ? chunks->write(set, values)
                         : H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0))
    fail_to_write(path, name);
}

std::vector<hsize_t> shape(const std::size_t n_values, const unsigned int n_columns)
{
  if (n_columns == 1)
    return {n_values};
  return {n_values / n_columns, n_columns};
}

char kind(const hid_t type)
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
      fail_to_read(path, name, "damaged" + reason());
    if (kind(type) != expected)
      fail_to_read(path, name,
                   std::string("it does not hold ") + (expected == 'd'   ? "numbers of double precision"
                                                       : expected == 'u' ? "integers"
                                                                         : "text"));
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    if (n < 0)
      fail_to_read(path, name, "damaged" + reason());
    size = static_cast<std::size_t>(n);
  }

  void read(const std::string &path, const std::string &name, const hid_t memory_type, void *values) const
  {
    if (size > 0 && H5Dread(set, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
      fail_to_read(path, name, "damaged" + reason());
  }

  Handle set, type, space;
  std::size_t size = 0;
};

void put_attribute(const std::string &path,
                   const hid_t file,
                   const std::string &object,
                   const std::string &name,
                   const hid_t type,
                   const void *value)
{
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT,
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
  const Handle attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  if (attribute < 0)
    fail_to_read(path, full, "there is no such attribute" + reason());
  const Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (kind(type) != expected || H5Sget_simple_extent_npoints(space) != 1)
    fail_to_read(path, full, "it has another type");
  std::string bytes(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, bytes.data()) < 0)
    fail_to_read(path, full, "damaged" + reason());
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

Hdf5File::Hdf5File(const std::string &path, const Mode mode, const unsigned int compression_level)
    : path(path), in_memory(mode == Mode::create), compression_level(compression_level)
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  if (mode == Mode::create)
  {
    write_bytes(path, nullptr, 0); // a place that cannot be written shows before the work is done
    file = create_hdf5_image(path);
    if (file < 0)
      fail_to_write(path, "");
  }
  else
  {
    file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0)
      throw InputError("cannot read " + path + " as an HDF5 file" + reason());
  }
}

Hdf5File::~Hdf5File()
{
  if (file >= 0)
    H5Fclose(file);
}

void Hdf5File::close(const bool sealed)
{
  if (in_memory)
  {
    const Hdf5Image image = hdf5_image(file, path);
    write_bytes(path, image.bytes, image.size, sealed ? seal_of(image.bytes, image.size) : "");
  }
  const hid_t closing = file;
  file = -1;
  if (H5Fclose(closing) < 0)
    fail_to_write(path, "");
}

void Hdf5File::write(const std::string &name, const std::vector<double> &values, const unsigned int n_columns)
{
  write_dataset(path, file, name, H5T_NATIVE_DOUBLE, shape(values.size(), n_columns), values.data(),
                compression_level);
}

void Hdf5File::write(const std::string &name,
                     const std::vector<std::uint64_t> &values,
                     const unsigned int n_columns)
{
  write_dataset(path, file, name, H5T_NATIVE_UINT64, shape(values.size(), n_columns), values.data(),
                compression_level);
}

void Hdf5File::write(const std::string &name, const std::string &text)
{
  // One row of the text's length; no row when it is empty, for HDF5 has no strings of length zero.
  write_dataset(path, file, name, text_type(text.size()), {text.empty() ? 0u : 1u}, text.data(), 0);
}

void Hdf5File::write(const std::string &name, const std::vector<std::string> &texts)
{
  std::size_t width = 1;
  for (const std::string &text : texts)
    width = std::max(width, text.size());
  std::string padded;
  for (const std::string &text : texts)
    padded += text + std::string(width - text.size(), '\0');
  write_dataset(path, file, name, text_type(width), {texts.size()}, padded.data(), 0);
}

std::vector<double> Hdf5File::read_doubles(const std::string &name) const
{
  const Source source(*this, path, file, name, 'd');
  std::vector<double> values(source.size);
  source.read(path, name, H5T_NATIVE_DOUBLE, values.data());
  return values;
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
  put_attribute(path, file, object, name, text_type(text.size()), text.c_str());
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
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  if (H5Lcreate_external(target.c_str(), object.c_str(), file, name.c_str(), links, H5P_DEFAULT) < 0)
    fail_to_write(path, name);
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
  const auto visit = [](hid_t, const char *name, const H5O_info_t *info, void *data) -> herr_t
  {
    if (info->type == H5O_TYPE_DATASET)
      static_cast<std::vector<std::string> *>(data)->push_back(name);
    return 0;
  };
  if (H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, visit, &names) < 0)
    throw InputError("cannot list what is in " + path + reason());
  return names;
}

char Hdf5File::array_type(const std::string &name) const
{
  const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (set < 0)
    fail_to_read(path, name, "damaged" + reason());
  return kind(Handle(H5Dget_type(set), H5Tclose));
}
} // namespace softgrain
