// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/late_files.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace softgrain
{
namespace
{
[[noreturn]] void fail(const std::string &what, const std::string &path)
{
  throw ComputationError("cannot " + what + " " + path + ": " + std::strerror(errno));
}

void bring_to_disk(const std::string &path, const int flags)
{
  const int descriptor = ::open(path.c_str(), flags);
  if (descriptor < 0)
    fail("open", path);
  int status = ::fsync(descriptor);
  while (status != 0 && errno == EINTR)
    status = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  // Some file systems know no fsync of a folder; the rename is still in order there.
  if (status != 0 && reason != EINVAL)
  {
    errno = reason;
    fail("bring to the disk", path);
  }
}
} // namespace

std::string folder_of_file(const std::string &path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

void bring_file_to_disk(const std::string &path)
{
  bring_to_disk(path, O_RDONLY);
}

void bring_folder_to_disk(const std::string &path)
{
  bring_to_disk(path, O_RDONLY | O_DIRECTORY);
}

AtomicFile::AtomicFile(const std::string &final_path)
    : whole_path(final_path), part_path(final_path + ".part")
{
  std::error_code error;
  std::filesystem::create_directories(folder_of_file(whole_path), error);
  if (error)
    throw ComputationError("cannot make the folder " + folder_of_file(whole_path) + ": " + error.message());
  // A rename would put a file in the place of a device, or of a link to one.
  if (std::filesystem::exists(whole_path, error) && !std::filesystem::is_regular_file(whole_path, error))
    throw ComputationError("cannot write " + whole_path + ": what is there is no file");
}

AtomicFile::~AtomicFile()
{
  if (!committed)
    ::unlink(part_path.c_str());
}

void AtomicFile::write(const std::string &content)
{
  const int file = ::open(part_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
    fail("write", part_path);
  std::size_t done = 0;
  while (done < content.size())
  {
    const ssize_t n = ::write(file, content.data() + done, content.size() - done);
    if (n > 0)
      done += n;
    else if (errno != EINTR)
      break;
  }
  const int reason = errno;
  // Some file systems tell only now what they could not write.
  const bool closed = ::close(file) == 0;
  if (done < content.size())
    errno = reason;
  if (done < content.size() || !closed)
    fail("write", part_path);
}

void AtomicFile::sync()
{
  bring_file_to_disk(part_path);
}

void AtomicFile::rename()
{
  if (std::rename(part_path.c_str(), whole_path.c_str()) != 0)
    fail("rename " + part_path + " to", whole_path);
  committed = true;
}

void AtomicFile::commit()
{
  sync();
  rename();
  bring_folder_to_disk(folder_of_file(whole_path));
}

void AtomicFile::commit(LateFiles &later)
{
  rename();
  later.add(whole_path);
}

void write_file_atomically(const std::string &path, const std::string &content)
{
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

void write_file_atomically(const std::string &path, const std::string &content, LateFiles &later)
{
  AtomicFile file(path);
  file.write(content);
  file.commit(later);
}
} // namespace softgrain
