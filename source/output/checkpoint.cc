// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/hdf5_reader.h>
#include <softgrain/output/hdf5_writer.h>
#include <softgrain/output/seal.h>
#include <softgrain/output/snapshot_layout.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace softgrain
{
namespace
{
const std::string format_start = "softgrain checkpoint ";
const char *const contents_name = "contents";
const std::string format_name = format_start + "7";

/// The format that a file says it has, looked for in its bytes; empty when it says none.
std::string format_in(const std::string &path)
{
  constexpr std::size_t n_digits = 20; // at most
  std::ifstream in(path, std::ios::binary);
  std::string seen;
  std::vector<char> part(std::size_t(1) << 20);
  std::size_t begin = std::string::npos;
  while (in.read(part.data(), part.size()), in.gcount() > 0)
  {
    seen.append(part.data(), in.gcount());
    begin = seen.find(format_start);
    if (begin != std::string::npos && seen.size() > begin + format_start.size() + n_digits)
      break;
    if (begin == std::string::npos && seen.size() > format_start.size()) // it may reach into the next part
      seen.erase(0, seen.size() - format_start.size());
  }
  if (begin == std::string::npos)
    return "";
  const std::string digits = seen.substr(begin + format_start.size(), n_digits);
  const std::size_t n = std::min(digits.find_first_not_of("0123456789"), digits.size());
  return n > 0 ? format_start + digits.substr(0, n) : "";
}

bool starts_as_hdf5(const std::string &path)
{
  std::string first(4, '\0');
  return std::ifstream(path, std::ios::binary).read(first.data(), 4) && first == "\x89HDF";
}

void require_this_format(const std::string &path, const std::string &format)
{
  if (format != format_name)
    throw InputError(path + " is a '" + format + "', but softgrain " + SOFTGRAIN_VERSION + " reads '" +
                     format_name + "': go on with the version that has written it");
}
} // namespace

CheckpointWriter::CheckpointWriter(const std::string &final_path)
    : target(final_path), file(std::make_unique<Hdf5Writer>(target.temporary_path()))
{
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::note(const std::string &name, const char type, const std::size_t size)
{
  contents += name.substr(name.find_first_not_of('/')) + ' ' + type + ' ' + std::to_string(size) + '\n';
}

void CheckpointWriter::write(const std::string &name, const std::vector<double> &values)
{
  note(name, 'd', values.size());
  file->write(name, values);
}

void CheckpointWriter::write(const std::string &name, const std::vector<std::uint64_t> &values)
{
  note(name, 'u', values.size());
  file->write(name, values);
}

void CheckpointWriter::write(const std::string &name, const std::string &text)
{
  note(name, 't', text.size());
  file->write(name, text);
}

void CheckpointWriter::write_rows(const std::string &name,
                                  const std::size_t n_rows,
                                  const std::size_t width,
                                  const Fill &fill)
{
  note(name, 'd', n_rows * width);
  file->create_array(name, n_rows * width);
  std::vector<double> rows;
  const auto write_piece = [&](const std::size_t begin, const std::size_t end)
  {
    rows.resize((end - begin) * width);
    fill(begin, end, rows.data());
    file->write_piece(name, begin * width, rows.size(), rows.data());
  };
  for_pieces(n_rows, width, write_piece);
}

template <int dim>
void CheckpointWriter::write_snapshot(const std::string &group, const Snapshot<dim> &snapshot)
{
  softgrain::write_snapshot(*file, snapshot, true, group + "/");
  for (const std::string &name : file->array_names())
    if (name.compare(0, group.size() + 1, group + "/") == 0)
      note(name, file->array_type(name), file->array_size(name));
}

void CheckpointWriter::commit()
{
  file->write(contents_name, contents);
  file->write_attribute("/", "format", format_name);
  file->close(true);
  target.commit();
}

CheckpointReader::CheckpointReader(const std::string &path) : path(path)
{
  if (!std::filesystem::exists(path))
    throw InputError("there is no checkpoint " + path);
  if (!is_sealed(path))
  {
    const std::string format = format_in(path);
    if (!format.empty())
      require_this_format(path, format);
    if (!format.empty() || starts_as_hdf5(path))
      throw InputError("the checkpoint " + path +
                       " is damaged: its checksum does not fit; restart from an older one");
    throw InputError(path + " is not a checkpoint of softgrain");
  }
  file = std::make_unique<Hdf5Reader>(path);
  require_this_format(path, file->has_attribute("/", "format") ? file->read_text_attribute("/", "format")
                                                               : "sealed file of another kind");
  read_contents();
}

void CheckpointReader::read_contents()
{
  std::istringstream lines(file->read_text(contents_name));
  for (std::string line; std::getline(lines, line);)
  {
    // Type and size are the last two words; a name may have blanks.
    const std::size_t size = line.rfind(' '), type = size == 0 || size == std::string::npos
                                                         ? std::string::npos
                                                         : line.rfind(' ', size - 1);
    if (type == std::string::npos)
      refuse(contents_name, "'" + line + "' is no name with type and size");
    if (!listed.emplace(line.substr(0, type), line.substr(type + 1)).second)
      refuse(contents_name, "it lists '" + line.substr(0, type) + "' twice");
  }
  std::size_t n_there = 0;
  for (const std::string &there : file->array_names())
    if (there != contents_name)
    {
      if (listed.count(there) == 0)
        refuse(there, std::string("'") + contents_name + "' does not list it");
      ++n_there;
    }
  if (n_there < listed.size())
    for (const auto &one : listed)
      if (!file->contains(one.first))
        refuse(one.first, std::string("it is missing, and '") + contents_name + "' lists it");
}

void CheckpointReader::check_listed(const std::string &name, const char type, const std::size_t size) const
{
  const auto found = listed.find(name);
  const std::string here = type + (" " + std::to_string(size));
  if (found == listed.end() || found->second != here)
    refuse(name, "its type and size are '" + here + "', and '" + contents_name + "' lists '" +
                     (found == listed.end() ? "none" : found->second) + "'");
}

void CheckpointReader::check_finite(const std::string &name,
                                    const double *const values,
                                    const std::size_t n) const
{
  if (!std::all_of(values, values + n, [](const double value) { return std::isfinite(value); }))
    refuse(name, "it holds a number that is none or infinite");
}

void CheckpointReader::refuse(const std::string &name, const std::string &why) const
{
  throw InputError("cannot read '" + name + "' from " + path + ": " + why);
}

template <int dim>
Snapshot<dim> CheckpointReader::read_snapshot(const std::string &group) const
{
  for (const auto &one : listed)
    if (one.first.compare(0, group.size() + 1, group + "/") == 0)
      check_listed(one.first, file->array_type(one.first), file->array_size(one.first));
  if (!file->contains(group))
    refuse(group, "it is missing");
  return read_snapshot_group<dim>(*file, group + "/");
}

template void CheckpointWriter::write_snapshot<2>(const std::string &, const Snapshot<2> &);
template void CheckpointWriter::write_snapshot<3>(const std::string &, const Snapshot<3> &);
template Snapshot<2> CheckpointReader::read_snapshot<2>(const std::string &) const;
template Snapshot<3> CheckpointReader::read_snapshot<3>(const std::string &) const;

CheckpointReader::~CheckpointReader() = default;

std::size_t CheckpointReader::size(const std::string &name) const
{
  return file->size(name);
}

void CheckpointReader::rows(const std::string &name, const std::size_t width, const Take &take) const
{
  const std::size_t n = size(name);
  check_listed(name, 'd', n);
  std::vector<double> rows;
  const auto read_piece = [&](const std::size_t begin, const std::size_t end)
  {
    rows.resize((end - begin) * width);
    file->read_piece(name, begin * width, rows.size(), rows.data());
    check_finite(name, rows.data(), rows.size());
    take(begin, end, rows.data());
  };
  for_pieces(n / width, width, read_piece);
}

std::vector<double> CheckpointReader::doubles(const std::string &name) const
{
  std::vector<double> values = file->read_doubles(name);
  check_listed(name, 'd', values.size());
  check_finite(name, values.data(), values.size());
  return values;
}

std::vector<std::uint64_t> CheckpointReader::integers(const std::string &name) const
{
  std::vector<std::uint64_t> values = file->read_integers(name);
  check_listed(name, 'u', values.size());
  return values;
}

std::string CheckpointReader::text(const std::string &name) const
{
  std::string value = file->read_text(name);
  check_listed(name, 't', value.size());
  return value;
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
  return !format_in(path).empty();
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
