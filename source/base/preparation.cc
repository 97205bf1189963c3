// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/preparation.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace softgrain
{
namespace
{
/// Time before the first line: within a second of the start of the program, which takes its part of it.
constexpr std::chrono::milliseconds before_first(400);
/// Time between two lines; long preparations tell less often.
constexpr std::chrono::seconds between(1);
} // namespace

Preparation::Preparation(const std::string &what, const std::size_t n) : what(what), n(n) {}

bool Preparation::is_due()
{
  const Clock::time_point now = Clock::now();
  const Clock::duration waits =
      last == begin ? Clock::duration(before_first) : std::max<Clock::duration>(between, (now - begin) / 10);
  if (now - last < waits)
    return false;
  last = now;
  return true;
}

void Preparation::advance()
{
  const std::lock_guard<std::mutex> guard(mutex);
  ++n_done;
  if (is_due())
    std::clog << "making " << what << ": " << n_done << " of " << n << std::endl;
}

void Preparation::reach(const double share)
{
  const std::lock_guard<std::mutex> guard(mutex);
  if (is_due())
    std::clog << "making " << what << " of " << n << ": "
              << static_cast<int>(std::floor(100. * std::min(1., std::max(0., share)))) << " %" << std::endl;
}

PreparationLog::PreparationLog(const bool prints)
    : before(std::clog.rdbuf(prints ? std::cout.rdbuf() : nullptr))
{
}

PreparationLog::~PreparationLog()
{
  std::clog.rdbuf(before);
}
} // namespace softgrain
