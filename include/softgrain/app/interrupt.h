// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_interrupt_h
#define softgrain_app_interrupt_h

#include <csignal>
#include <map>

namespace softgrain
{
/**
 * @brief Turns signals that would end the program into requests to stop (base/interruption.h) while it lives.
 *
 * They are Ctrl-C, SIGTERM, SIGHUP, and SIGXCPU and SIGUSR1, which schedulers send before a limit. One that
 * comes a second later or more ends the program at once; sooner it is the same wish, sent to the group of
 * processes too. What is ignored when the program starts (nohup) stays ignored. A closed terminal comes back
 * as an error of writing, not as a signal.
 */
class InterruptGuard
{
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard &) = delete;
  InterruptGuard &operator=(const InterruptGuard &) = delete;

private:
  std::map<int, struct sigaction> old_actions;
};
} // namespace softgrain

#endif
