// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/command_line.h>
#include <softgrain/base/mpi_session.h>

#include <csignal>
#include <optional>

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
    mpi.emplace(argc, argv);
  return command_line.execute();
}
