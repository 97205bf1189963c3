// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/thread_team.h>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace softgrain::contact
{
namespace
{
/// Tells the processor that this is a waiting loop.
void relax()
{
#if defined(__x86_64__)
  _mm_pause();
#endif
}

/// Turns of a waiting loop before the thread leaves its core to others, some 0.1 ms.
constexpr unsigned int n_spins = 4000;
} // namespace

ThreadTeam::ThreadTeam(const unsigned int n_threads)
{
  for (unsigned int i = 1; i < n_threads; ++i)
    threads.emplace_back([this] { help(); });
}

ThreadTeam::~ThreadTeam()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    stop.store(true);
  }
  wake.notify_all();
  for (std::thread &thread : threads)
    thread.join();
}

void ThreadTeam::distribute(const std::uint32_t n_items, const Call loop_call, const void *loop_object)
{
  if (threads.empty() || n_items < 2)
  {
    for (std::uint32_t i = 0; i < n_items; ++i)
      loop_call(loop_object, i);
    return;
  }
  call = loop_call;
  object = loop_object;
  loop_start = loop_end.load(std::memory_order_relaxed);
  const std::uint64_t end = loop_start + n_items;
  // Hands over what stands above. In one order with n_asleep: either a thread that goes to sleep sees this
  // loop, or it is seen here.
  loop_end.store(end);
  if (n_asleep.load() > 0)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    wake.notify_all();
  }
  while (take_one())
  {
  }
  for (unsigned int turn = 0; done.load(std::memory_order_acquire) != end; ++turn)
    if (turn < n_spins)
      relax();
    else
      std::this_thread::yield();
}

bool ThreadTeam::take_one()
{
  std::uint64_t item = next.load(std::memory_order_relaxed);
  while (item < loop_end.load(std::memory_order_acquire))
    if (next.compare_exchange_weak(item, item + 1, std::memory_order_relaxed))
    {
      // The loop of this item cannot end before the item does, so its data stand.
      call(object, item - loop_start);
      done.fetch_add(1, std::memory_order_acq_rel);
      return true;
    }
  return false;
}

void ThreadTeam::help()
{
  for (unsigned int turn = 0; !stop.load(std::memory_order_relaxed); ++turn)
    if (take_one())
      turn = 0;
    else if (turn < n_spins)
      relax();
    else
    {
      sleep();
      turn = 0;
    }
}

void ThreadTeam::sleep()
{
  std::unique_lock<std::mutex> lock(mutex);
  n_asleep.fetch_add(1);
  wake.wait(lock, [this] { return stop.load() || next.load() < loop_end.load(); });
  n_asleep.fetch_sub(1);
}
} // namespace softgrain::contact
