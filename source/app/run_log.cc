// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/run_log.h>
#include <softgrain/base/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace softgrain
{
const char *const run_log_name = "run.log";

RunLog::RunLog(std::ostream &terminal) : screen(terminal), fork(screen, log), shared(&fork) {}

void RunLog::open(const std::string &directory, const bool append)
{
  const std::filesystem::path path = std::filesystem::path(directory) / run_log_name;
  bool half_a_line = false; // as a run leaves it that was killed
  if (std::ifstream old(path, std::ios::ate | std::ios::binary); append && old && old.tellg() > 0)
  {
    old.seekg(-1, std::ios::end);
    half_a_line = old.get() != '\n';
  }
  errno = 0;
  log.open(path, append ? std::ios::app : std::ios::trunc);
  if (!log)
    throw ComputationError("cannot write " + path.string() + ": " + std::strerror(errno != 0 ? errno : EIO));
  if (half_a_line)
    log << '\n';
}

// A terminal that was closed must not take the file with it, nor the other way round: errors stay with their
// stream.

RunLog::Fork::int_type RunLog::Fork::overflow(const int_type character)
{
  if (!traits_type::eq_int_type(character, traits_type::eof()))
  {
    const char one = traits_type::to_char_type(character);
    xsputn(&one, 1);
  }
  return traits_type::not_eof(character);
}

std::streamsize RunLog::Fork::xsputn(const char *const text, const std::streamsize size)
{
  first.write(text, size);
  second.write(text, size);
  return size;
}

int RunLog::Fork::sync()
{
  first.flush();
  second.flush();
  return 0;
}
} // namespace softgrain
