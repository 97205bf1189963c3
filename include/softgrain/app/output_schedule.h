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

  /// Whether the time is due at @p time; @p slack is what counts as there [s].
  bool due(double time, double slack) const { return time >= next() - slack; }

  /// Whether due() holds at @p time; if so, goes on to the next time. @p slack is what counts as there
  /// [s].
  bool reached(double time, double slack);

  /// Goes on from a restart: what is due at @p time or before has been written.
  void skip_to(double time, double slack);

private:
  double interval;
  unsigned long count = 0; ///< multiples of the interval already due
};

/**
 * @brief Limits steps so that they meet the next output exactly and leave no sliver before it.
 */
class StepPlanner
{
public:
  /// Part of a step that counts as nothing: closer than this is there.
  static constexpr double sliver = 1e-6;

  /// @param shared_by number of natural steps from which on the rest of the way is divided,
  /// Model::equal_steps()
  explicit StepPlanner(unsigned int shared_by) : shared_by(shared_by) {}

  /// The longest step allowed [s]: the rest of the way to @p target, or an equal part of it when fewer
  /// natural steps are left than share it.
  double limit(double time, double target);

  /// What the model made of the last limit() [s].
  void taken(double dt);

  /// The step the model takes when nothing limits it, as far as known [s]; 0 at the start.
  double natural_step() const { return natural; }
  void set_natural_step(double dt) { natural = dt; }

  /// What counts as having arrived [s].
  double slack() const { return sliver * natural; }

private:
  unsigned int shared_by;
  double natural = 0;
  double last_limit = 0;
};
} // namespace softgrain

#endif
