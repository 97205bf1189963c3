// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/history.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace softgrain
{
namespace
{
const std::string first_columns = "time_s,step,";

/// Ten digits: enough for every measure, and short enough to read; whole numbers stay whole.
std::string text_of(const double value)
{
  if (!std::isfinite(value))
    return "";
  char buffer[40];
  std::snprintf(buffer, sizeof(buffer), "%.10g", value);
  return buffer;
}

/// @throw InputError when two columns have one name
void check_names_differ(const std::string &names, const std::string &path)
{
  std::istringstream list(names);
  std::set<std::string> seen;
  for (std::string name; std::getline(list, name, ',');)
    if (!seen.insert(name).second)
      throw InputError(path + ": two columns are called '" + name + "'");
}

std::uint64_t step_of(const std::string &line, const std::string &path)
{
  const auto begin = line.find(',') + 1;
  try
  {
    const double step = std::stod(line.substr(begin));
    if (!(step >= 0. && step < 1e18))
      throw std::out_of_range("no number of a step");
    return static_cast<std::uint64_t>(step);
  }
  catch (const std::exception &)
  {
    throw InputError(path + ": cannot be continued, there is no step in '" + line + "'");
  }
}
} // namespace

HistoryLine line_of(const HistoryRow &row)
{
  HistoryLine line;
  for (const auto &[name, value] : row)
  {
    line.names += (line.names.empty() ? "" : ",") + name;
    line.values += (&name == &row.front().first ? "" : ",") + text_of(value);
  }
  return line;
}

HistoryWriter::HistoryWriter(const std::string &directory, const std::string &file_name)
    : path((std::filesystem::path(directory) / file_name).string())
{
}

HistoryWriter::~HistoryWriter()
{
  if (descriptor >= 0)
    ::close(descriptor);
}

void HistoryWriter::open(const bool append)
{
  descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_APPEND | (append ? 0 : O_TRUNC), 0666);
  if (descriptor < 0)
    throw ComputationError(path + ": cannot be written: " + std::strerror(errno));
}

void HistoryWriter::resume(const std::uint64_t step,
                           const std::vector<std::string> &columns,
                           const bool own_row_stays)
{
  std::ifstream old(path);
  if (!old)
    return;
  std::string line;
  // A line without an end was being written when the program died: getline then reaches the end.
  if (!std::getline(old, header) || old.eof())
  {
    header.clear();
    return;
  }
  if (header.compare(0, first_columns.size(), first_columns) != 0)
    throw InputError(path + ": cannot be continued, it is not a table of softgrain");
  std::string names;
  for (const std::string &column : columns)
    names += (names.empty() ? "" : ",") + column;
  if (!columns.empty())
    check_columns(names);
  std::string kept = header + "\n";
  while (std::getline(old, line) && !old.eof())
  {
    const std::uint64_t of_line = step_of(line, path);
    if (of_line > step)
      continue;
    kept += line + "\n";
    if (of_line == step && !own_row_stays)
      cut_first = true;
    else
      end_of_rows = kept.size();
  }
  end_of_rows = std::max<std::uint64_t>(end_of_rows, header.size() + 1);
  old.close();
  write_file_atomically(path, kept);
  open(true);
}

void HistoryWriter::check_columns(const std::string &names) const
{
  if (names != header)
    throw InputError(path + ": cannot be continued, its columns are '" + header + "' and not '" + names +
                     "'");
}

void HistoryWriter::append(const std::string &text)
{
  std::size_t done = 0;
  while (done < text.size())
  {
    const ssize_t n = ::write(descriptor, text.data() + done, text.size() - done);
    if (n > 0)
      done += n;
    else if (errno != EINTR)
      break;
  }
  if (done == text.size())
  {
    end_of_rows += done;
    return;
  }
  const std::string reason = std::strerror(errno);
  // What has come of the row goes again: readers find whole rows only.
  if (::ftruncate(descriptor, static_cast<off_t>(end_of_rows)) != 0)
    throw ComputationError(path + ": cannot be written: " + reason + ", and ends with half a row");
  throw ComputationError(path + ": cannot be written: " + reason);
}

void HistoryWriter::write_line(const HistoryLine &line)
{
  const bool first = descriptor < 0;
  if (first)
  {
    check_names_differ(line.names, path);
    open(false);
    header = line.names;
  }
  check_columns(line.names);
  if (!std::filesystem::exists(path))
    throw ComputationError(path + " was removed during the run");
  if (cut_first && ::ftruncate(descriptor, static_cast<off_t>(end_of_rows)) != 0)
    throw ComputationError(path + ": cannot be written: " + std::strerror(errno));
  cut_first = false;
  // Each row is handed to the system at once, so that what is seen from outside is whole rows.
  append((first ? header + "\n" : "") + line.values + "\n");
}

void HistoryWriter::bring_to_disk() const
{
  if (descriptor >= 0 && ::fsync(descriptor) != 0 && errno != EINVAL)
    throw ComputationError(path + ": cannot be written: " + std::strerror(errno));
}
} // namespace softgrain
