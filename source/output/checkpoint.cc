// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/hdf5_file.h>

#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace softgrain
{
namespace
{
const std::string format_start = "softgrain checkpoint ";
const std::string format_name = format_start + "3";

/// Of name, type and content, so that no array can pass for another.
std::uint64_t checksum(const std::string &name, const char type, const void *data, const std::size_t n_bytes)
{
  const std::string plain = name.substr(std::min(name.find_first_not_of('/'), name.size()));
  const std::string head = plain + '\n' + type;
  uLong sum = ::crc32_z(0, reinterpret_cast<const Bytef *>(head.data()), head.size());
  if (n_bytes > 0) // zlib takes a null pointer for a request to start anew
    sum = ::crc32_z(sum, static_cast<const Bytef *>(data), n_bytes);
  return sum;
}

std::uint64_t checksum(const Hdf5File &file, const std::string &name)
{
  switch (const char type = file.array_type(name))
  {
  case 'd':
  {
    const std::vector<double> values = file.read_doubles(name);
    return checksum(name, type, values.data(), values.size() * sizeof(double));
  }
  case 'u':
  {
    const std::vector<std::uint64_t> values = file.read_integers(name);
    return checksum(name, type, values.data(), values.size() * sizeof(std::uint64_t));
  }
  default:
  {
    const std::string text = file.read_text(name);
    return checksum(name, type, text.data(), text.size());
  }
  }
}
} // namespace

CheckpointWriter::CheckpointWriter(const std::string &final_path)
    : target(final_path), file(std::make_unique<Hdf5File>(target.temporary_path(), Hdf5File::Mode::create))
{
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::write(const std::string &name, const std::vector<double> &values)
{
  file->write(name, values);
  sum_of_checksums += checksum(name, 'd', values.data(), values.size() * sizeof(double));
  ++n_arrays;
}

void CheckpointWriter::write(const std::string &name, const std::vector<std::uint64_t> &values)
{
  file->write(name, values);
  sum_of_checksums += checksum(name, 'u', values.data(), values.size() * sizeof(std::uint64_t));
  ++n_arrays;
}

void CheckpointWriter::write(const std::string &name, const std::string &text)
{
  file->write(name, text);
  sum_of_checksums += checksum(name, 't', text.data(), text.size());
  ++n_arrays;
}

void CheckpointWriter::commit()
{
  file->write_attribute("/", "format", format_name);
  file->write_attribute("/", "n_arrays", n_arrays);
  file->write_attribute("/", "checksum", sum_of_checksums);
  file->close();
  target.commit();
}

CheckpointReader::CheckpointReader(const std::string &path) : path(path)
{
  if (!std::filesystem::exists(path))
    throw InputError("there is no checkpoint " + path);
  file = std::make_unique<Hdf5File>(path, Hdf5File::Mode::read);
  if (!file->has_attribute("/", "format") || !file->has_attribute("/", "checksum"))
    throw InputError(path + " is not a whole checkpoint of softgrain");
  const std::string format = file->read_text_attribute("/", "format");
  if (format != format_name)
    throw InputError(path + " is a '" + format + "', but softgrain " + SOFTGRAIN_VERSION + " reads '" +
                     format_name + "': go on with the version that has written it");
  const std::vector<std::string> names = file->array_names();
  std::uint64_t sum = 0;
  try
  {
    for (const std::string &name : names)
      sum += checksum(*file, name);
  }
  catch (const std::bad_alloc &)
  {
    sum = ~file->read_integer_attribute("/", "checksum"); // a length that is damaged
  }
  catch (const std::length_error &)
  {
    sum = ~file->read_integer_attribute("/", "checksum");
  }
  if (names.size() != file->read_integer_attribute("/", "n_arrays") ||
      sum != file->read_integer_attribute("/", "checksum"))
    throw InputError("the checkpoint " + path +
                     " is damaged: its checksum does not fit; restart from an older one");
}

CheckpointReader::~CheckpointReader() = default;

std::vector<double> CheckpointReader::read_doubles(const std::string &name) const
{
  return file->read_doubles(name);
}

std::vector<std::uint64_t> CheckpointReader::read_integers(const std::string &name) const
{
  return file->read_integers(name);
}

std::string CheckpointReader::read_text(const std::string &name) const
{
  return file->read_text(name);
}

bool CheckpointReader::contains(const std::string &name) const
{
  return file->contains(name);
}

std::string checkpoint_path(const std::string &directory, const std::uint64_t step)
{
  const std::string digits = std::to_string(step);
  const std::string zeros(digits.size() < 9 ? 9 - digits.size() : 0, '0');
  return directory + "/state-" + zeros + digits + ".h5";
}

std::string stage_path(const std::string &directory, const std::string &stage)
{
  return directory + "/stage-" + stage + ".h5";
}

bool is_stage_name(const std::string &name)
{
  return name.size() > 9 && name.compare(0, 6, "stage-") == 0 && name.compare(name.size() - 3, 3, ".h5") == 0;
}

bool is_checkpoint_name(const std::string &name)
{
  return name.size() > 9 && name.compare(0, 6, "state-") == 0 &&
         name.compare(name.size() - 3, 3, ".h5") == 0 &&
         name.find_first_not_of("0123456789", 6) == name.size() - 3;
}

bool is_checkpoint(const std::string &path)
{
  try
  {
    const Hdf5File file(path, Hdf5File::Mode::read);
    return file.has_attribute("/", "format") &&
           file.read_text_attribute("/", "format").compare(0, format_start.size(), format_start) == 0;
  }
  catch (const InputError &)
  {
    return false;
  }
}

std::vector<std::string> checkpoint_paths(const std::string &directory)
{
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto &entry : std::filesystem::directory_iterator(directory, error))
    if (is_checkpoint_name(entry.path().filename()))
      paths.push_back(entry.path());
  const auto newer = [](const std::string &first, const std::string &second)
  { return first.size() != second.size() ? first.size() > second.size() : first > second; };
  std::sort(paths.begin(), paths.end(), newer);
  return paths;
}

std::string latest_checkpoint(const std::string &directory)
{
  std::string last_problem;
  for (const std::string &path : checkpoint_paths(directory))
    try
    {
      CheckpointReader reader(path);
      return path;
    }
    catch (const InputError &error)
    {
      last_problem = std::string(": ") + error.what();
    }
  throw InputError("there is no whole checkpoint (state-*.h5) in " + directory + last_problem);
}

std::optional<std::string> newest_checkpoint(const std::string &directory)
{
  const std::vector<std::string> paths = checkpoint_paths(directory);
  return paths.empty() ? std::nullopt : std::optional<std::string>(paths.front());
}

void remove_checkpoints_after(const std::string &directory, const std::uint64_t step)
{
  const std::string last = checkpoint_path(directory, step);
  std::error_code error;
  for (const std::string &path : checkpoint_paths(directory))
    if ((path.size() > last.size() || (path.size() == last.size() && path > last)) && is_checkpoint(path))
      std::filesystem::remove(path, error);
}

void remove_old_checkpoints(const std::string &directory, const unsigned int keep)
{
  const std::vector<std::string> paths = checkpoint_paths(directory);
  std::error_code error; // one that cannot be removed does no harm
  for (std::size_t i = keep; i < paths.size(); ++i)
    if (is_checkpoint(paths[i]))
      std::filesystem::remove(paths[i], error);
}
} // namespace softgrain
