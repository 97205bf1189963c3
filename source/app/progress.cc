// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/progress.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace softgrain
{
namespace
{
constexpr std::chrono::milliseconds terminal_interval(200);
constexpr std::chrono::seconds file_interval(5);
} // namespace

Progress::Progress(std::ostream &out, const bool is_terminal)
    : out(out), is_terminal(is_terminal), begin(Clock::now()), last_shown(begin)
{
}

void Progress::update(const double time,
                      const std::uint64_t step,
                      const StepReport &report,
                      const double fraction,
                      const double start)
{
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - begin).count();
  const double done = fraction - start;
  char buffer[200];
  std::snprintf(buffer, sizeof(buffer),
                "t = %.4e s  step %llu  dt %.2e s  Newton %u  sweeps %u  residual %.1e  %5.1f %%", time,
                static_cast<unsigned long long>(step), report.dt, report.newton_iterations,
                report.contact_sweeps, std::max(report.newton_residual, report.contact_residual),
                100 * std::min(fraction, 1.));
  line = buffer;
  if (done > 0)
    line += "  left " + duration_in_words(std::max(0., elapsed * (1 - fraction) / done));
  line_is_new = true;
  const bool due = is_terminal ? now - last_shown >= terminal_interval : now - last_shown >= file_interval;
  if (due)
  {
    last_shown = now;
    show();
  }
}

void Progress::show()
{
  if (is_terminal)
  {
    const std::size_t blanks = shown_length > line.size() ? shown_length - line.size() : 0;
    out << '\r' << line << std::string(blanks, ' ') << std::flush;
    shown_length = line.size();
  }
  else
    out << line << std::endl;
  line_is_new = false;
}

void Progress::finish()
{
  if (line_is_new)
    show();
  if (is_terminal && shown_length > 0)
    out << '\n';
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
  else
    std::snprintf(buffer, sizeof(buffer), "%ld s", rounded);
  return buffer;
}
} // namespace softgrain
