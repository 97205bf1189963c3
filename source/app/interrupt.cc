// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/interrupt.h>

namespace softgrain
{
namespace
{
// A signal handler can reach nothing but this.
volatile std::sig_atomic_t signal_seen = 0;

extern "C" void note_signal(int)
{
  signal_seen = 1;
}
} // namespace

InterruptGuard::InterruptGuard()
{
  signal_seen = 0;
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &old_interrupt);
  sigaction(SIGTERM, &action, &old_terminate);
}

InterruptGuard::~InterruptGuard()
{
  sigaction(SIGINT, &old_interrupt, nullptr);
  sigaction(SIGTERM, &old_terminate, nullptr);
}

bool InterruptGuard::requested() const
{
  return signal_seen != 0;
}
} // namespace softgrain
