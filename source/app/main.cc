// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/command_line.h>
#include <softgrain/base/mpi_session.h>

#include <sys/resource.h>

#include <csignal>
#include <iostream>
#include <optional>

namespace
{
/// What libraries need that would end the program in words of their own, and some for the files of a run.
constexpr rlim_t fewest_open_files = 40;

bool has_few_files()
{
  rlimit files{};
  return getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_cur < fewest_open_files;
}
} // namespace

int main(int argc, char **argv)
{
  // A file that may not grow comes back as an error of writing, to the very end: streams write again when
  // they close.
  std::signal(SIGXFSZ, SIG_IGN);
  softgrain::CommandLine command_line;
  if (const std::optional<int> done = command_line.parse(argc, argv))
    return *done;
  // The other commands start faster without it.
  std::optional<softgrain::MPISession> mpi;
  if (command_line.builds_model())
  {
    if (has_few_files())
    {
      std::cerr << "softgrain: error: too few files may be open at once: " << fewest_open_files
                << " are needed (ulimit -n)" << std::endl;
      return 1;
    }
    mpi.emplace(argv);
  }
  return command_line.execute();
}
