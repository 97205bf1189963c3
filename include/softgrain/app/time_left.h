// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_time_left_h
#define softgrain_app_time_left_h

#include <optional>

namespace softgrain
{
/**
 * @brief Estimates how long a run will still take from how fast it went of late.
 *
 * Steps become dearer while contacts form, so only the later part of the time counts: the pace is that since
 * a quarter to a half of it. The first step, which prepares what the others use, does not count.
 */
class TimeLeft
{
public:
  /// Notes that @p fraction of the work is done after @p seconds of computing.
  void add(double seconds, double fraction);

  /// Seconds [s]; nothing before the second step.
  std::optional<double> seconds() const;

private:
  struct Moment
  {
    double seconds, fraction;
  };

  unsigned int n_steps = 0;
  Moment first; ///< end of the first step
  Moment from;  ///< the pace is taken from here
  Moment next;  ///< and from here when twice as much time has gone by
  Moment last;
};
} // namespace softgrain

#endif
