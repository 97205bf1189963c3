// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_output_schedule_h
#define softgrain_app_output_schedule_h

namespace softgrain
{
/**
 * @brief Times at which something is written: multiples of an interval, met exactly by the steps.
 */
class OutputSchedule
{
public:
  /// @param interval [s]; 0: never
  explicit OutputSchedule(double interval);

  bool active() const { return interval > 0; }

  /// The next time due, infinite when there is none [s].
  double next() const;

  /// Whether the time is due at @p time; if so, goes on to the next one. @p slack is what counts as there
  /// [s].
  bool reached(double time, double slack);

  /// Goes on from a restart: what is due at @p time or before has been written.
  void skip_to(double time, double slack);

private:
  double interval;
  unsigned long count = 0; ///< multiples of the interval already due
};

/**
 * @brief The longest step that still meets @p target: the rest of the way, or half of it when the step before
 * would leave only a sliver.
 */
double step_limit(double time, double target, double last_dt);
} // namespace softgrain

#endif
