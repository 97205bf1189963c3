// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>

#include <deal.II/base/multithread_info.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace softgrain
{
unsigned int n_threads()
{
  return dealii::MultithreadInfo::n_threads();
}

void set_n_threads(const unsigned int n)
{
  // deal.II hands the limit to TBB, so one call serves both.
  dealii::MultithreadInfo::set_thread_limit(n == 0 ? dealii::MultithreadInfo::n_cores() : n);
}

void parallel_for(const std::size_t n,
                  const std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)> &work)
{
  if (n <= grain || n_threads() == 1)
  {
    if (n > 0)
      work(0, n);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                    [&work](const tbb::blocked_range<std::size_t> &range)
                    { work(range.begin(), range.end()); });
}
} // namespace softgrain
