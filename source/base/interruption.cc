// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>

#include <atomic>

namespace softgrain
{
namespace
{
// Global, for a signal handler reaches nothing else.
std::atomic<bool> noted(false), requested(false), must_be_told(false);
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");
} // namespace

void request_interruption() noexcept
{
  noted = true;
  if (!must_be_told)
    requested = true;
}

void forget_interruption() noexcept
{
  noted = false;
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

void await_telling_of_interruption() noexcept
{
  must_be_told = true;
}

bool interruption_noted() noexcept
{
  return noted;
}

void tell_interruption() noexcept
{
  noted = true;
  requested = true;
}
} // namespace softgrain
