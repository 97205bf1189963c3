// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>

#include <deal.II/base/multithread_info.h>

#include <tbb/parallel_for.h>

#include <dlfcn.h>

#include <algorithm>

namespace softgrain
{
namespace
{
/// A BLAS with threads of its own would cut its products by the cores that it sees, so that bits would depend
/// on them, and take cores from other processes. UMFPACK calls it.
void keep_blas_to_one_thread()
{
  using SetThreads = void (*)(int);
  if (void *const set = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<SetThreads>(set)(1);
}
} // namespace

unsigned int n_threads()
{
  return dealii::MultithreadInfo::n_threads();
}

void set_n_threads(const unsigned int n)
{
  // deal.II hands the limit to TBB, so one call serves both.
  dealii::MultithreadInfo::set_thread_limit(n == 0 ? dealii::MultithreadInfo::n_cores() : n);
  keep_blas_to_one_thread();
}

void internal::run_pieces(const std::size_t n,
                          const std::size_t grain,
                          void (*const call)(const void *, std::size_t, std::size_t),
                          const void *const work)
{
  // The same pieces whatever the number of threads: what is vectorised may round differently in the
  // remainder of a piece, so other cuts could change the last bit.
  const std::size_t n_pieces = (n + grain - 1) / grain;
  const auto run = [&](const std::size_t piece)
  { call(work, piece * grain, std::min(n, (piece + 1) * grain)); };
  if (n_pieces <= 1 || n_threads() == 1)
  {
    for (std::size_t piece = 0; piece < n_pieces; ++piece)
      run(piece);
    return;
  }
  tbb::parallel_for(std::size_t(0), n_pieces, run);
}
} // namespace softgrain
