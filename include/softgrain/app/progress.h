// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_progress_h
#define softgrain_app_progress_h

#include <softgrain/app/time_left.h>
#include <softgrain/model/model.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace softgrain
{
class RunLog;

/**
 * @brief Tells how far a run is: one line that changes on a terminal, in run.log and where the output goes to
 * a file a line every few seconds, of a long run every hundredth of its time so far.
 */
class Progress
{
public:
  /// @param is_terminal whether a line can be written over
  Progress(RunLog &log, bool is_terminal);

  /// Lets time count from here on, before the first step.
  void start();

  /// Shows a step; @p fraction of the work is done.
  void update(double time, std::uint64_t step, const StepReport &report, double fraction);

  /// Another stage begins, whose steps may take longer or less long than those before.
  void next_stage() { time_left = TimeLeft(); }

  /// Shows the last step if it has not been shown, and ends the line.
  void finish();

private:
  using Clock = std::chrono::steady_clock;

  void show_on_terminal();
  void show_in_files();

  RunLog &log;
  const bool is_terminal;
  Clock::time_point begin;
  Clock::time_point last_on_terminal;
  Clock::time_point last_in_files;
  TimeLeft time_left;
  std::string line;
  std::size_t shown_length = 0;
  bool new_on_terminal = false;
  bool new_in_files = false;
};

/// "2 h 05 min", "3 min 20 s", "12 s".
std::string duration_in_words(double seconds);
} // namespace softgrain

#endif
