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

bool hang_up_ignored = false;

/// Notes whether a hang-up is to be ignored, as nohup wants it. This runs before libraries begin: on Debian
/// 13 one of them takes the signal for itself while it is loaded, and the default is there when main()
/// begins.
void note_hang_up(int, char **, char **)
{
  struct sigaction action = {};
  hang_up_ignored = sigaction(SIGHUP, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const before_libraries)(int, char **, char **) = note_hang_up;

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
    if (hang_up_ignored)
      std::signal(SIGHUP, SIG_IGN);
  }
  return command_line.execute();
}
