// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/hdf5_file.h>
#include <softgrain/output/seal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace softgrain
{
namespace
{
const std::string format_start = "softgrain checkpoint ";
const std::string format_name = format_start + "5";

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
    : target(final_path), file(std::make_unique<Hdf5File>(target.temporary_path(), Hdf5File::Mode::create))
{
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::write(const std::string &name, const std::vector<double> &values)
{
  file->write(name, values);
}

void CheckpointWriter::write(const std::string &name, const std::vector<std::uint64_t> &values)
{
  file->write(name, values);
}

void CheckpointWriter::write(const std::string &name, const std::string &text)
{
  file->write(name, text);
}

void CheckpointWriter::write_rows(const std::string &name,
                                  const std::size_t n_rows,
                                  const std::size_t width,
                                  const Fill &fill)
{
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

void CheckpointWriter::commit()
{
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
  file = std::make_unique<Hdf5File>(path, Hdf5File::Mode::read);
  require_this_format(path, file->has_attribute("/", "format") ? file->read_text_attribute("/", "format")
                                                               : "sealed file of another kind");
}

CheckpointReader::~CheckpointReader() = default;

std::size_t CheckpointReader::size(const std::string &name) const
{
  return file->size(name);
}

void CheckpointReader::read_rows(const std::string &name, const std::size_t width, const Take &take) const
{
  std::vector<double> rows;
  const auto read_piece = [&](const std::size_t begin, const std::size_t end)
  {
    rows.resize((end - begin) * width);
    file->read_piece(name, begin * width, rows.size(), rows.data());
    take(begin, end, rows.data());
  };
  for_pieces(size(name) / width, width, read_piece);
}

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
