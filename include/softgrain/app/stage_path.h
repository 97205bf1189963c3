// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_stage_path_h
#define softgrain_app_stage_path_h

#include <softgrain/driving/stages.h>
#include <softgrain/model/model.h>

#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/**
 * @brief Where a run is on its path of stages: which one it is in, and when and with which walls that began.
 */
template <int dim>
class StagePath
{
public:
  StagePath(const Stages &stages, Model<dim> &model, const Loads<dim> &loads);

  bool empty() const { return stages.empty(); }
  unsigned int number() const { return current; } ///< from 0
  const std::string &name() const { return stages[current].name; }

  /// Enters the first stage, if there is one: its walls are driven as it says.
  void begin();
  /// Enters the next stage. @param run_done part of the whole run that is done, by its own stop conditions
  void next(double run_done = 0.);

  /// How long the stages are expected to last, of which only ratios count. Without, or empty: all last alike.
  void expect(const std::vector<double> &durations);

  /// Shows the stop conditions of the present stage every step.
  void note(double slack);
  /// What they have seen.
  const StopMemory &memory() const { return seen; }
  /// Forgets a step that is taken back. @param before memory() before it
  void take_back(const StopMemory &before) { seen = before; }

  /// Part of the present stage that is done. @param slack what counts as having arrived [s]
  double fraction_of_stage(double slack) const;
  bool is_last() const { return current + 1 >= stages.size(); }
  /// Part of the whole path, by how long the stages are expected to last. The present one ends by its own
  /// stop conditions or those of the run, whichever have come farther since it began. @param run_done as in
  /// next()
  double fraction_done(double slack, double run_done) const;
  /// The end of the present stage if it is known beforehand [s]; 0: it is not.
  double end_time() const;

  /// @param ends whether the present stage is done
  void save(StateWriter &writer, bool ends) const;
  /// Loads the path before the model is loaded: its walls are driven as they were.
  /// @return whether the state was written as the end of its stage, after its row of the history. The next
  /// stage then begins before the first step.
  bool load(const StateReader &reader);

private:
  RunStateIn<dim> state(double slack) const;

  const Stages &stages;
  Model<dim> &model;
  const Loads<dim> &loads;
  unsigned int current = 0;
  double begin_time = 0.; ///< [s]
  double run_done_at_begin = 0.;
  std::vector<double> expected; ///< durations of all stages
  std::vector<WallState<dim>> walls_at_begin;
  StopMemory seen; ///< by the stop conditions of the present stage
};

/// Whether the present stage has come to its end.
template <int dim>
bool stage_is_done(const StagePath<dim> &path, const double slack)
{
  return path.fraction_of_stage(slack) >= 1.;
}

/// How many stages had begun in the state of a checkpoint; the parameters of the others may still change.
std::size_t number_of_stages_begun(const StateReader &reader);
} // namespace softgrain

#endif
