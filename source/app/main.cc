// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/command_line.h>

#include <deal.II/base/mpi.h>

#include <optional>

int main(int argc, char **argv)
{
  softgrain::CommandLine command_line;
  if (const std::optional<int> done = command_line.parse(argc, argv))
    return *done;
  // Trilinos and HDF5 are built with MPI; the other commands start faster without it.
  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  if (command_line.builds_model())
    mpi.emplace(argc, argv);
  return command_line.execute();
}
