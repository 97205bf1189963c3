// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/interrupt.h>
#include <softgrain/base/interruption.h>

#include <ctime>

namespace softgrain
{
namespace
{
// A signal handler can reach nothing but this.
volatile std::sig_atomic_t second_of_first_signal = 0;

extern "C" void note_signal(const int signal)
{
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  const auto second = static_cast<std::sig_atomic_t>(now.tv_sec);
  if (!interruption_noted())
    second_of_first_signal = second;
  else if (second - second_of_first_signal > 1)
  {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  request_interruption();
}
} // namespace

InterruptGuard::InterruptGuard()
{
  forget_interruption();
  const auto install = [this](const int signal, void (*const handler)(int))
  {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, nullptr, &old_actions[signal]);
    if (old_actions[signal].sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1})
    install(signal, note_signal);
  install(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard()
{
  for (const auto &[signal, action] : old_actions)
    sigaction(signal, &action, nullptr);
}
} // namespace softgrain
