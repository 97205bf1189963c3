// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_interrupt_h
#define softgrain_app_interrupt_h

#include <csignal>

namespace softgrain
{
/**
 * @brief While it lives, Ctrl-C and SIGTERM are only noted; a second one ends the program at once.
 */
class InterruptGuard
{
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard &) = delete;
  InterruptGuard &operator=(const InterruptGuard &) = delete;

  /// Whether a signal has come.
  bool requested() const;

private:
  struct sigaction old_interrupt;
  struct sigaction old_terminate;
};
} // namespace softgrain

#endif
