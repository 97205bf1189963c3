// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/command_line.h>

#include <deal.II/base/mpi.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <optional>

int main(int argc, char **argv)
{
  softgrain::CommandLine command_line;
  if (const std::optional<int> done = command_line.parse(argc, argv))
    return *done;
  // A program on its own needs no other process; Open MPI would start one, which needs room for files of its
  // own.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  // Trilinos and HDF5 are built with MPI; the other commands start faster without it.
  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  if (command_line.builds_model())
  {
    // Under nohup a hang-up is ignored; MPI puts back the default, which ends the program.
    struct sigaction hang_up;
    const bool ignored = sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_IGN;
    mpi.emplace(argc, argv);
    if (ignored)
      std::signal(SIGHUP, SIG_IGN);
  }
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
