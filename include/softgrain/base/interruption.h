// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_interruption_h
#define softgrain_base_interruption_h

#include <exception>

namespace softgrain
{
/**
 * @brief Ends a step that is under way because the program is to stop: not a failure.
 *
 * Whoever throws or passes it on leaves the state of the model as it was before the step.
 */
class Interrupted : public std::exception
{
public:
  const char *what() const noexcept override { return "interrupted"; }
};

/// @name Whether the program is to stop soon, by Ctrl-C or by the time limit of a scheduler. A signal handler
/// may request it; iterations that can take long look at it once in a while.
///@{
void request_interruption() noexcept;
void forget_interruption() noexcept;
bool interruption_requested() noexcept;
/// @throw Interrupted when it was requested
void stop_if_interrupted();
///@}

/// @name Programs of several processes have to stop at the same place: a request is noted where it comes, and
/// counts when all have been told, which is when they next meet.
///@{
/// From now on a request only counts when it has been told.
void await_telling_of_interruption() noexcept;
/// Whether this process has been requested to stop, told or not.
bool interruption_noted() noexcept;
void tell_interruption() noexcept;
///@}
} // namespace softgrain

#endif
