// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/progress.h>
#include <softgrain/app/run_log.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace softgrain
{
namespace
{
constexpr std::chrono::milliseconds terminal_interval(200);
constexpr std::chrono::seconds file_interval(5);
} // namespace

Progress::Progress(RunLog &log, const bool is_terminal) : log(log), is_terminal(is_terminal)
{
  start();
}

void Progress::start()
{
  begin = last_on_terminal = last_in_files = Clock::now();
}

void Progress::update(const double time,
                      const std::uint64_t step,
                      const StepReport &report,
                      const double fraction)
{
  const Clock::time_point now = Clock::now();
  const Clock::duration elapsed = now - begin;
  time_left.add(std::chrono::duration<double>(elapsed).count(), fraction);
  char buffer[200];
  std::snprintf(buffer, sizeof(buffer),
                "t = %.4e s  step %llu  dt %.2e s  Newton %u  sweeps %u  residual %.1e  %5.1f %%", time,
                static_cast<unsigned long long>(step), report.dt, report.newton_iterations,
                report.contact_sweeps, std::max(report.newton_residual, report.contact_residual),
                100 * std::min(fraction, 1.));
  line = buffer;
  if (const std::optional<double> left = time_left.seconds())
    line += "  left " + duration_in_words(*left);
  new_in_files = true;
  new_on_terminal = is_terminal;
  if (is_terminal && now - last_on_terminal >= terminal_interval)
  {
    last_on_terminal = now;
    show_on_terminal();
  }
  if (now - last_in_files >= std::max<Clock::duration>(file_interval, elapsed / 100))
  {
    last_in_files = now;
    show_in_files();
  }
}

void Progress::show_on_terminal()
{
  const std::size_t blanks = shown_length > line.size() ? shown_length - line.size() : 0;
  log.terminal() << '\r' << line << std::string(blanks, ' ') << std::flush;
  shown_length = line.size();
  new_on_terminal = false;
}

void Progress::show_in_files()
{
  (is_terminal ? log.file() : log.both()) << line << std::endl;
  new_in_files = false;
}

void Progress::finish()
{
  if (new_in_files)
    show_in_files();
  if (new_on_terminal)
    show_on_terminal();
  if (shown_length > 0)
    log.terminal() << '\n';
  shown_length = 0;
}

std::string duration_in_words(const double seconds)
{
  char buffer[40];
  // Beyond a century nobody waits, and the number must fit.
  const long rounded = std::lround(std::min(seconds, 3.2e9));
  if (rounded >= 3600)
    std::snprintf(buffer, sizeof(buffer), "%ld h %02ld min", rounded / 3600, rounded % 3600 / 60);
  else if (rounded >= 60)
    std::snprintf(buffer, sizeof(buffer), "%ld min %02ld s", rounded / 60, rounded % 60);
  else if (rounded >= 10)
    std::snprintf(buffer, sizeof(buffer), "%ld s", rounded);
  else
    std::snprintf(buffer, sizeof(buffer), "%.2g s", std::round(100 * seconds) / 100);
  return buffer;
}
} // namespace softgrain
