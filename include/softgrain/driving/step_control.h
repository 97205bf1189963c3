// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_step_control_h
#define softgrain_driving_step_control_h

#include <functional>
#include <limits>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// What StepControl may be told; section `Time`.
struct StepSettings
{
  double time_step = 0;        ///< [s]; 0: the model has a step of its own
  double smallest_step = 1e-4; ///< relative to the wanted step; below it the run gives up

  /// Declares 'Time step' and 'Smallest step' where the handler stands.
  /// @param zero what 'Time step' = 0 means
  static void declare_parameters(dealii::ParameterHandler &prm,
                                 const std::string &zero,
                                 const std::string &smallest_step);
  void parse_parameters(const dealii::ParameterHandler &prm);

  /// The step asked for [s]. @param own of the model, when the user gives none
  double wanted(const double own) const { return time_step > 0. ? time_step : own; }
};

/// What one attempt at a step came to.
struct Attempt
{
  bool accepted = false;
  std::string reason;   ///< why not
  bool may_grow = true; ///< whether the next step may be longer than this one, when that was cut
  double share = 0.5;   ///< of the length of a step that is not accepted with which it is tried again
};

/// A limit on the next step beside what is due and what is wanted, as that in which nothing can pass unseen.
struct SafeStep
{
  double dt = std::numeric_limits<double>::infinity(); ///< [s]
  /// The run ends where safe steps are shorter than this [s].
  double shortest = 0;
  std::function<std::string()> cause; ///< of the limit: names body and place
};

/// What StepControl::advance() did.
struct StepTaken
{
  double dt = 0; ///< [s]
  unsigned int attempts = 1;
};

/**
 * @brief Repeats steps that fail with half their length, or with the share of it that they ask for, and lets
 * steps grow again afterwards.
 */
class StepControl
{
public:
  /// @param growth factor on the next step after one that may grow
  explicit StepControl(const double growth) : growth(growth) {}

  /**
   * @brief Calls @p attempt with ever shorter steps until it accepts one.
   * @param settings the smallest step
   * @param wanted   the step that the model wants to make [s]
   * @param dt_limit the longest that is allowed [s]
   * @param time     at the start of the step [s]
   * @param attempt  leaves the state as it was when it does not accept
   * @param safe     another limit
   * @throw ComputationError when no acceptable step is found, and when time no longer moves: steps that are
   * lost in the rounding of the time, safe steps that are too short, or thousand steps in a row of which none
   * was ten times as long as 'Smallest step' allows. Interrupted as @p attempt does: the length of steps is
   * then that before the call
   */
  StepTaken advance(const StepSettings &settings,
                    double wanted,
                    double dt_limit,
                    double time,
                    const std::function<Attempt(double dt)> &attempt,
                    const SafeStep &safe = SafeStep());

  /// Length of the steps over that wanted, after cuts; what a checkpoint keeps.
  double scale = 1.;

private:
  /// @throw ComputationError when safe steps are too short, or all of the last were
  void check_that_time_moves(double time, double wanted, double asked, const SafeStep &safe) const;
  /// Takes note of an accepted step.
  void note(double dt, double floor);

  const double growth;
  unsigned int n_short = 0; ///< steps in a row that were hardly longer than the smallest
  double way_of_short = 0.; ///< their lengths together [s]
  std::string last_refusal; ///< why the last step that failed did
};
} // namespace softgrain

#endif
