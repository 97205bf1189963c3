// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>

#include <atomic>

namespace softgrain
{
namespace
{
// Global, for a signal handler reaches nothing else.
std::atomic<bool> requested(false);
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");
} // namespace

void request_interruption() noexcept
{
  requested = true;
}

void forget_interruption() noexcept
{
  requested = false;
}

bool interruption_requested() noexcept
{
  return requested.load(std::memory_order_relaxed);
}

void stop_if_interrupted()
{
  if (interruption_requested())
    throw Interrupted();
}
} // namespace softgrain
