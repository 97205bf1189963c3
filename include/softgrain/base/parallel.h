// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_parallel_h
#define softgrain_base_parallel_h

#include <cstddef>

namespace softgrain
{
/// Number of threads that parallel loops use.
unsigned int n_threads();

/// Limits the threads of every parallel loop, deal.II's included; 0 means one per core.
void set_n_threads(unsigned int n);

namespace internal
{
/// Calls call(work, begin, end) for the pieces of parallel_for().
void run_pieces(std::size_t n,
                std::size_t grain,
                void (*call)(const void *, std::size_t, std::size_t),
                const void *work);
} // namespace internal

/**
 * @brief Calls @p work(begin, end) on pieces of [0, n) on all threads.
 *
 * Pieces are @p grain long, the last may be shorter, whatever the number of threads. @p work must write only
 * to what belongs to its own indices: then the result does not depend on the number of threads. An exception
 * thrown by a piece is rethrown here. Nothing is allocated with one thread: loops of a step call this often.
 */
template <class Work>
void parallel_for(const std::size_t n, const std::size_t grain, const Work &work)
{
  internal::run_pieces(
      n, grain,
      [](const void *object, const std::size_t begin, const std::size_t end)
      { (*static_cast<const Work *>(object))(begin, end); },
      &work);
}
} // namespace softgrain

#endif
