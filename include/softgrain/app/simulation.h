// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_simulation_h
#define softgrain_app_simulation_h

#include <softgrain/analysis/measure.h>
#include <softgrain/app/input.h>
#include <softgrain/app/interrupt.h>
#include <softgrain/app/output_schedule.h>
#include <softgrain/app/progress.h>
#include <softgrain/app/run_lock.h>
#include <softgrain/app/run_log.h>
#include <softgrain/app/run_statistics.h>
#include <softgrain/app/stage_path.h>
#include <softgrain/app/waiting_output.h>
#include <softgrain/base/ranks.h>
#include <softgrain/output/history.h>
#include <softgrain/output/snapshot_file.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
class CheckpointReader;

/**
 * @brief Drives a model from step to step until the scene's stop conditions, and writes what the run leaves.
 *
 * All ranks drive their part of the model through the same steps; the first one writes.
 */
template <int dim>
class Simulation
{
public:
  Simulation(const Input &input, Model<dim> &model, const RunLock &lock, std::ostream &terminal);

  /// What the run is expected to take, to be printed at its start.
  void expect(const SizeReport &report) { expected = report; }
  /// How long its stages are expected to last [s].
  void expect_stages(const std::vector<double> &durations) { path.expect(durations); }

  /**
   * @brief Goes on from a checkpoint: history, pictures and snapshots are cut back to it, and what it says
   * is still to be written of its state is written first.
   * @param file_name of the checkpoint, for the log
   * @param changes of parameters since the checkpoint, for the log
   * @throw InputError when it cannot be read
   */
  void restart(CheckpointReader &checkpoint,
               const std::string &file_name,
               const std::vector<std::string> &changes = {});

  /// A line for the head of the log.
  void say(const std::string &line) { first_lines += line + '\n'; }

  /**
   * @brief Computes to the end, or until a signal asks the program to stop, within a step if need be.
   * @return "completed" or "interrupted"
   * @throw ComputationError after the last good state has been saved
   */
  std::string run();

private:
  /// What the stop conditions of the whole run have seen, in checkpoints.
  static constexpr const char *stop_seen_name = "driver/stop_seen";

  SizeReport expected;
  std::string first_lines;
  void open_log(bool append);
  void print_head();
  void start_files();
  /// Cuts the files of the folder back to the checkpoint.
  void resume_files();
  void print_ranks();
  /// @return the text of @p error, or that the output folder is gone, which explains it.
  std::string cause_of(const ComputationError &error) const;
  /// Keeps the state after a ComputationError, and draws it. @return what to add to its @p message
  std::string save_after_failure(const std::string &message);
  /// The end of a run that failed: summary.json says so, if the disk lets it.
  void note_failure();
  /// The state in which a run ends before its time, in all files; the run that goes on takes it out again.
  void write_last_state();
  std::string loop();
  /// One step, fit to be written where it will be. After an exception all is as before it.
  StepReport take_step();
  bool finished() const { return finished(run_done()); }
  /// Whether the stage is at its end, where run_done() is known to be @p of_run.
  bool finished(double of_run) const;
  /// Part of the way to the stop conditions of the whole run.
  double run_done() const;
  /// Part of the work that is done, stage by stage: 0 at the start of the run, 1 at its end.
  double fraction_done() const;
  double next_target() const;
  /// Lets the model settle after a step of whose state something is written.
  void settle_if_written(StepReport &report);
  /// What stop conditions of the whole run look at.
  RunStateIn<dim> run_state() const;
  /// What is due of the state, by the intervals and because a stage or the run ends.
  void write_due_output();
  /// Energies of the state; they are noted for the balance in the summary.
  Energies note_energies();
  HistoryRow history_row(const Energies &energies) const;
  /// Puts together what is to be written of the state, for write_waiting().
  void prepare_output(const OutputParts &parts, const Energies &energies);
  /// Writes what waits. What the disk refuses, and what comes after it, goes on waiting.
  void write_waiting();
  OutputParts all_parts() const;
  void write_checkpoint();
  /// The state in a file of this name.
  void write_state(const std::string &file);
  /// Where a stage ends that is not the last, after its output: a checkpoint that is kept; the next one
  /// begins.
  void end_stage();
  /// Walls are driven as the next stage says; a checkpoint.
  void begin_next_stage();
  /// Whether the present stage is done and another one follows.
  bool next_stage_is_due() const;
  void write_summary(const std::string &status);
  void print_end(const std::string &status);

  const Scene<dim> &scene;
  const StopConditions &stop;
  Model<dim> &model;
  const RunParameters &parameters;
  const std::string effective_parameters;
  const RunLock &lock;
  const Ranks ranks; ///< the first one writes
  RunLog log;

  const std::vector<WallState<dim>> walls_at_start;
  RunStatistics statistics;
  Progress progress;
  HistoryWriter history;
  FieldWriter fields;
  SnapshotFile snapshots;
  ContactLoads loads; ///< columns of the history
  MeasureSeriesIn<dim> measures;
  HistoryWriter measure_table;
  OutputSchedule field_schedule;
  OutputSchedule snapshot_schedule;
  bool restarted = false;
  StepPlanner planner;
  StagePath<dim> path;
  bool at_end_of_stage = false; ///< the run goes on where a stage has ended and the next has not begun
  StopMemory seen;              ///< by the stop conditions of the whole run
  StepReport last_report;       ///< of the step that led to the state
  WaitingOutput<dim> waiting;
  std::uint64_t step_of_start = 0; ///< of the run, or where it goes on
  bool step_given_up = false;      ///< the model has begun a step after that of the state
  bool has_begun = false;          ///< the folder says that it belongs to this run
  bool last_state_tried = false;   ///< by write_last_state()
};

/// First lines of a run: which program with how many threads, which model, and where its results go. They are
/// printed before bodies are made, which may take long.
std::string head_of_log(const RunParameters &run, const Ranks &ranks);

/// Prints names and values in two columns.
void print_size_report(std::ostream &out, const SizeReport &report);
} // namespace softgrain

#endif
