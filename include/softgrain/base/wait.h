// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_wait_h
#define softgrain_base_wait_h

#include <softgrain/base/rank_times.h>

namespace softgrain
{
/// A clock that only goes forward [s].
double steady_seconds();

/// Books what passes while it lives as waiting.
class Wait
{
public:
  explicit Wait(RankTimes &times)
      : times(times), begin(steady_seconds()), processor_begin(processor_seconds())
  {
  }
  ~Wait()
  {
    times.waiting += steady_seconds() - begin;
    times.spinning += processor_seconds() - processor_begin;
    ++times.messages;
  }
  Wait(const Wait &) = delete;
  Wait &operator=(const Wait &) = delete;

private:
  RankTimes &times;
  const double begin, processor_begin;
};
} // namespace softgrain

#endif
