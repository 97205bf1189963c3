// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/history.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
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

HistoryWriter::HistoryWriter(const std::string &directory, const std::string &file_name)
    : path((std::filesystem::path(directory) / file_name).string())
{
}

void HistoryWriter::open(const bool append)
{
  file.open(path, append ? std::ios::app : std::ios::trunc);
  if (!file)
    throw ComputationError(path + ": cannot be written");
}

void HistoryWriter::resume(const std::uint64_t step, const std::vector<std::string> &columns)
{
  std::ifstream old(path);
  if (!old)
    return;
  std::string line;
  std::getline(old, header);
  if (header.compare(0, first_columns.size(), first_columns) != 0)
    throw InputError(path + ": cannot be continued, it is not a table of softgrain");
  std::string names;
  for (const std::string &column : columns)
    names += (names.empty() ? "" : ",") + column;
  if (!columns.empty())
    check_columns(names);
  std::string kept = header + "\n";
  // A row that was being written when the program died has no end of line: getline then reaches the end.
  while (std::getline(old, line) && !old.eof())
    if (step_of(line, path) <= step)
      kept += line + "\n";
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

void HistoryWriter::write(const HistoryRow &row)
{
  std::string names, values;
  for (const auto &[name, value] : row)
  {
    names += (names.empty() ? "" : ",") + name;
    values += (&name == &row.front().first ? "" : ",") + text_of(value);
  }
  if (!file.is_open())
  {
    open(false);
    header = names;
    file << header << '\n';
  }
  check_columns(names);
  if (!std::filesystem::exists(path))
    throw ComputationError(path + " was removed during the run");
  // Each row is handed to the system at once, so that what is seen from outside is whole rows.
  errno = 0;
  file << values << '\n' << std::flush;
  if (!file)
    throw ComputationError(path + ": cannot be written: " + std::strerror(errno));
}
} // namespace softgrain
