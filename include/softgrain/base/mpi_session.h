// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_mpi_session_h
#define softgrain_base_mpi_session_h

#include <deal.II/base/mpi.h>

#include <csignal>
#include <cstdlib>
#include <optional>

namespace softgrain
{
/**
 * @brief MPI for the life of this object; Trilinos and HDF5 are built with it, and ranks need it.
 *
 * Open MPI gives a process that no launcher has started a folder below the temporary one, and the same to
 * every other such process of a user: of programs that start and end at the same moment some then abort,
 * since one removes the folder in which the other is just making its own (32 of 2400 starts, six at a time).
 * A process on its own needs neither the folder nor a helper process, so both are switched off, unless the
 * environment says otherwise. Nor does it need memory that it shares with others; Open MPI 5 makes a file of
 * 16 MB for it, and complains in words of its own where files may not grow so large. Nor does it need UCX,
 * which sleeps for 0.2 s in every start to measure the clock where /proc/cpuinfo does not name its speed.
 */
class MPISession
{
public:
  /// @param argv its first element is the name of the program. The others are not handed on: libraries that
  /// start with MPI (Kokkos, PETSc) would take options for theirs.
  explicit MPISession(char **argv)
  {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
    {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
      setenv("OMPI_MCA_btl", "self", 0);
      setenv("OMPI_MCA_pml", "ob1", 0);
    }
    // Under nohup a hang-up is ignored; MPI puts back the default, which ends the program.
    struct sigaction hang_up;
    const bool ignored = sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_IGN;
    char *name_alone[] = {argv[0], nullptr};
    int one = 1;
    char **names = name_alone;
    mpi.emplace(one, names);
    if (ignored)
      std::signal(SIGHUP, SIG_IGN);
  }

private:
  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
};
} // namespace softgrain

#endif
