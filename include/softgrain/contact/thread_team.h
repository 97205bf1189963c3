// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_thread_team_h
#define softgrain_contact_thread_team_h

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Threads that stay awake between loops, for sweeps of a millisecond with a barrier every 0.1 ms.
 *
 * A task scheduler pays tens of microseconds to wake its threads. Here they spin for the short time between
 * two loops and take single items from a common counter; when no loop comes for longer they sleep, for the
 * system runs a thread that has slept before one that has used up its share by waiting. The calling thread
 * works too and waits only for items already taken: a thread that the system does not run holds nobody up.
 */
class ThreadTeam
{
public:
  /// @param n_threads size of the team, the calling thread included
  explicit ThreadTeam(unsigned int n_threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam &) = delete;
  ThreadTeam &operator=(const ThreadTeam &) = delete;

  /// Calls work(i) once for every i in [0, n_items), in no order; it must not throw.
  template <class Work>
  void run(const std::uint32_t n_items, const Work &work)
  {
    // Through a pointer even when alone: two compiled copies of the work may round differently.
    distribute(
        n_items, [](const void *object, const std::uint32_t i) { (*static_cast<const Work *>(object))(i); },
        &work);
  }

private:
  using Call = void (*)(const void *, std::uint32_t);

  void distribute(std::uint32_t n_items, Call call, const void *object);
  bool take_one(); ///< does the next item, if there is one
  void help();     ///< what the other threads do all their life
  void sleep();    ///< until there is an item, or the end

  // Items are numbered through all loops, so that a late thread cannot mistake an item of one loop for
  // one of the next. Written between loops only:
  Call call = nullptr;
  const void *object = nullptr;
  std::uint64_t loop_start = 0;

  // Each on its own cache line.
  alignas(64) std::atomic<std::uint64_t> loop_end{0};
  alignas(64) std::atomic<std::uint64_t> next{0};
  alignas(64) std::atomic<std::uint64_t> done{0};
  std::atomic<bool> stop{false};
  std::atomic<unsigned int> n_asleep{0};
  std::mutex mutex;
  std::condition_variable wake;
  std::vector<std::thread> threads;
};
} // namespace softgrain::contact

#endif
