// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/wait.h>

#include <chrono>
#include <ctime>

namespace softgrain
{
double steady_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_seconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}
} // namespace softgrain
