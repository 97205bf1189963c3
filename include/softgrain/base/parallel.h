// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_parallel_h
#define softgrain_base_parallel_h

#include <cstddef>
#include <functional>

namespace softgrain
{
/// Number of threads that parallel loops use.
unsigned int n_threads();

/// Limits the threads of every parallel loop, deal.II's included; 0 means one per core.
void set_n_threads(unsigned int n);

/**
 * @brief Calls @p work(begin, end) on pieces of [0, n) on all threads.
 *
 * Pieces are @p grain long, the last may be shorter, whatever the number of threads. @p work must write only
 * to what belongs to its own indices: then the result does not depend on the number of threads. An exception
 * thrown by a piece is rethrown here.
 */
void parallel_for(std::size_t n,
                  std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)> &work);
} // namespace softgrain

#endif
