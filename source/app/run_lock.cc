// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/run_lock.h>
#include <softgrain/base/exceptions.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace softgrain
{
namespace
{
std::string host_name()
{
  char name[256] = "";
  gethostname(name, sizeof(name) - 1);
  return name;
}

/// Whether the text of a lock names a process that lives on this machine.
bool names_living_process(const std::string &owner)
{
  std::istringstream words(owner);
  std::string process, on, host;
  pid_t id = 0;
  return words >> process >> id >> on >> host && host == host_name() && id != getpid() &&
         (kill(id, 0) == 0 || errno == EPERM);
}
} // namespace

const char *const RunLock::file_name = "run.lock";

RunLock::RunLock(const std::string &directory, const Ranks &ranks)
    : directory(directory), path(directory + "/" + file_name)
{
  ranks.at_first([this]() { take(); });
}

void RunLock::take()
{
  const std::string what = "'Output directory' = '" + directory + "' ";
  std::error_code error;
  made_folder = std::filesystem::create_directories(directory, error);
  if (error)
    throw InputError(what + "cannot be made: " + error.message());
  // Once more when the run before has just removed the file; not for ever where a file never is itself.
  for (unsigned int attempt = 0; attempt == 0 || (!is_ours() && attempt < 100); ++attempt)
  {
    if (descriptor >= 0)
      ::close(descriptor);
    descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw InputError(what + "cannot be written: " + path + ": " + std::strerror(errno));
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool no_locks_here = !locked && errno != EWOULDBLOCK;
    const std::string text = owner();
    if (!locked && (!no_locks_here || names_living_process(text)))
    {
      ::close(descriptor);
      throw InputError(what + "is in use by another run" + (text.empty() ? "" : " (" + text + ")") +
                       ": wait for its end, or name another folder");
    }
  }
  const std::string text = "process " + std::to_string(getpid()) + " on " + host_name() + "\n";
  if (ftruncate(descriptor, 0) != 0 ||
      pwrite(descriptor, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
  {
    const std::string reason = std::strerror(errno);
    ::close(descriptor);
    throw InputError(what + "cannot be written: " + path + ": " + reason);
  }
}

RunLock::~RunLock()
{
  if (descriptor < 0)
    return;
  if (is_ours())
  {
    ::unlink(path.c_str());
    if (made_folder)
      ::rmdir(directory.c_str()); // does nothing when something is in it
  }
  ::close(descriptor);
}

void RunLock::check_folder() const
{
  if (!is_ours())
    throw ComputationError("the output folder " + directory +
                           " is gone: it was removed, renamed or replaced during the run");
}

bool RunLock::is_ours() const
{
  struct stat held, there;
  return ::fstat(descriptor, &held) == 0 && ::stat(path.c_str(), &there) == 0 &&
         held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

std::string RunLock::owner() const
{
  char text[300];
  const ssize_t size = pread(descriptor, text, sizeof(text), 0);
  const std::string all(text, size > 0 ? size : 0);
  return all.substr(0, all.find('\n'));
}
} // namespace softgrain
