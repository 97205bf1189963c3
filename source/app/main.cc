// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/command_line.h>
#include <softgrain/base/mpi_session.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <optional>

int main(int argc, char **argv)
{
  softgrain::CommandLine command_line;
  if (const std::optional<int> done = command_line.parse(argc, argv))
    return *done;
  // The other commands start faster without it.
  std::optional<softgrain::MPISession> mpi;
  if (command_line.builds_model())
    mpi.emplace(argc, argv);
  if (mpi && dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cerr
          << "softgrain: error: started as several processes, which would all compute the same: leave mpirun "
             "out and choose the number of threads with --threads"
          << std::endl;
    return 2;
  }
  return command_line.execute();
}
