// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_progress_h
#define softgrain_app_progress_h

#include <softgrain/model/model.h>

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace softgrain
{
/**
 * @brief Tells how far a run is: one line that changes on a terminal, a line every few seconds in a file.
 */
class Progress
{
public:
  /// @param is_terminal whether a line can be written over
  Progress(std::ostream &out, bool is_terminal);

  /// After a step; @p fraction of the way is done, of which @p start was done before this process.
  void update(double time, std::uint64_t step, const StepReport &report, double fraction, double start);

  /// Shows the last step if it has not been shown, and ends the line.
  void finish();

private:
  using Clock = std::chrono::steady_clock;

  void show();

  std::ostream &out;
  const bool is_terminal;
  const Clock::time_point begin;
  Clock::time_point last_shown;
  std::string line;
  std::size_t shown_length = 0;
  bool line_is_new = false;
};

/// "2 h 05 min", "3 min 20 s", "12 s".
std::string duration_in_words(double seconds);
} // namespace softgrain

#endif
