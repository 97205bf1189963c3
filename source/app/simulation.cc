// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/history_columns.h>
#include <softgrain/app/measure_table.h>
#include <softgrain/app/output_folder.h>
#include <softgrain/app/simulation.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/summary.h>
#include <softgrain/scene/contact_pairs.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>

namespace softgrain
{
namespace
{
/// What measures need to know, which are taken in the plane alone.
std::optional<double> friction_of(const Scene<2> &scene)
{
  return uniform_friction(scene);
}
std::optional<double> friction_of(const Scene<3> &)
{
  return std::nullopt;
}

double seconds_since(const std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace

template <int dim>
Simulation<dim>::Simulation(const Input &input,
                            Model<dim> &model,
                            const RunLock &lock,
                            std::ostream &terminal)
    : scene(input.scene_in<dim>())
    , stop(input.stop())
    , model(model)
    , parameters(input.run())
    , effective_parameters(input.effective_parameters())
    , lock(lock)
    , log(terminal)
    , walls_at_start(model.walls())
    , statistics(model)
    , progress(log, isatty(STDOUT_FILENO) != 0)
    , history(parameters.output_directory)
    , fields(parameters.output_directory, parameters.fields)
    , snapshots(parameters.output_directory, parameters.snapshots)
    , loads(dim == 2 ? contact_loads(parameters.loads, input.scene()) : ContactLoads())
    , measures(parameters.measures, friction_of(scene))
    , measure_table(parameters.output_directory, measure_table_name)
    , field_schedule(parameters.fields_every)
    , snapshot_schedule(parameters.snapshots_every)
    , planner(model.equal_steps())
    , path(input.stages(), model, scene.loads)
{
}

template <int dim>
void Simulation<dim>::restart(CheckpointReader &checkpoint,
                              const std::string &file_name,
                              const std::vector<std::string> &changes)
{
  at_end_of_stage = path.load(checkpoint);
  model.load(checkpoint);
  statistics.load(checkpoint);
  planner.set_natural_step(checkpoint.read_doubles("driver/natural_step", 1)[0]);
  field_schedule.skip_to(model.time(), planner.slack());
  snapshot_schedule.skip_to(model.time(), planner.slack());
  seen = load_stop_memory(checkpoint, stop_seen_name);
  ranks.together([&]() { waiting = WaitingOutput<dim>::load(checkpoint, ranks.first()); });
  step_of_start = model.step();
  ranks.at_first([this]() { resume_files(); });
  restarted = true;
  for (const std::string &change : changes)
    log.both() << "changed since the checkpoint: " << change << '\n';
  log.both() << "going on from " << file_name << ", step " << model.step() << '\n';
}

template <int dim>
void Simulation<dim>::resume_files()
{
  // What has been written of this state and is not due at it gives way to what comes.
  const double time = model.time(), before = std::nextafter(time, -std::numeric_limits<double>::infinity());
  history.resume(model.step(), {}, waiting.written.history);
  fields.resume(waiting.written.fields ? time : before);
  const double until = waiting.written.snapshots ? time : before;
  snapshots.resume(until);
  if (!measures.measures().empty())
  {
    measure_table.resume(model.step(), measure_columns(measures.measures()), waiting.written.measures);
    remember_snapshots(measures, parameters.output_directory, until);
    if (waiting.snapshot && waiting.parts.snapshots)
      measures.remember(*waiting.snapshot);
  }
  remove_unfinished_files(parameters.output_directory);
  open_log(true);
}

template <int dim>
std::string Simulation<dim>::run()
{
  const InterruptGuard interrupt;
  try
  {
    start_files();
    print_head();
    const std::string status = loop();
    progress.finish();
    write_checkpoint();
    if (status == "interrupted")
      write_last_state();
    write_summary(status);
    print_end(status);
    return status;
  }
  catch (const ComputationError &error)
  {
    ranks.fail_alike(error.what());
    progress.finish();
    const std::string cause = cause_of(error);
    // Before that nothing may be left that looks like files of somebody else.
    const std::string message = cause + (has_begun ? save_after_failure(cause) : "");
    log.file() << "error: " << message << std::endl; // main() tells the terminal
    throw ComputationError(message);
  }
  catch (const std::exception &error)
  {
    ranks.fail_alike(error.what());
    // Nobody knows what state the model is in, so the checkpoints on the disk stay the last good ones.
    progress.finish();
    note_failure();
    log.file() << "error: " << error.what() << std::endl;
    throw;
  }
}

template <int dim>
std::string Simulation<dim>::cause_of(const ComputationError &error) const
{
  // A folder may be lost between any two of its files. Whichever file missed it first, this is what happened.
  try
  {
    ranks.at_first([this]() { lock.check_folder(); });
    return error.what();
  }
  catch (const ComputationError &lost)
  {
    return lost.what();
  }
}

template <int dim>
std::string Simulation<dim>::save_after_failure(const std::string &message)
{
  std::string text;
  try
  {
    write_checkpoint();
    text = "; the last good state is saved in " + checkpoint_path(parameters.output_directory, model.step());
  }
  catch (const std::exception &second)
  {
    // A disk that is full refuses twice with the same words.
    if (second.what() != message)
      text = std::string("; and the state could not be saved: ") + second.what();
    const std::optional<std::string> older = newest_checkpoint(parameters.output_directory);
    text += older ? "; the newest checkpoint is " + *older : "; there is no checkpoint";
  }
  try
  {
    // After a refusal it is the state that would be drawn which waits.
    if (!waiting.parts.any())
      write_last_state();
  }
  catch (const std::exception &second)
  {
    if (second.what() != message)
      text += std::string("; and this state could not be drawn: ") + second.what();
  }
  note_failure();
  return text;
}

template <int dim>
void Simulation<dim>::note_failure()
{
  if (!ranks.first() || !has_begun)
    return;
  const Summary summary = statistics.summary("failed", model);
  try
  {
    lock.check_folder();
    softgrain::write_summary(parameters.output_directory, summary);
  }
  catch (const ComputationError &)
  {
    overwrite_summary(parameters.output_directory, summary);
  }
}

template <int dim>
void Simulation<dim>::start_files()
{
  const std::filesystem::path folder = parameters.output_directory;
  ranks.at_first(
      [&]()
      {
        if (!restarted)
          remove_old_results(folder.string());
        write_file_atomically((folder / "parameters.prm").string(), effective_parameters);
        if (!restarted)
          open_log(false);
      });
  has_begun = true;
  write_summary("running");
  if (!restarted)
    path.begin();
  // Another folder than that of the checkpoint begins with the state that the run goes on from.
  if (!restarted || ranks.any(ranks.first() && history.is_new()))
  {
    const bool stage = waiting.parts.stage;
    prepare_output(all_parts(), note_energies());
    waiting.parts.stage = stage;
  }
  write_waiting();
}

template <int dim>
std::string Simulation<dim>::loop()
{
  progress.start();
  if (at_end_of_stage && !finished() && next_stage_is_due())
    end_stage();
  auto last_checkpoint = std::chrono::steady_clock::now();
  while (!finished() && !interruption_requested())
  {
    if (const std::string moved = model.share_out_anew(); !moved.empty())
      log.file() << moved << std::endl;
    try
    {
      last_report = take_step();
    }
    catch (const Interrupted &)
    {
      break; // all is as it was before the step
    }
    statistics.add_step(last_report);
    write_due_output();
    if (next_stage_is_due())
      end_stage();
    progress.update(model.time(), model.step(), last_report, fraction_done());
    // The clock of the first rank counts.
    if (parameters.checkpoint_minutes > 0 &&
        ranks.any(ranks.first() && seconds_since(last_checkpoint) > 60 * parameters.checkpoint_minutes))
    {
      write_checkpoint();
      write_summary("running");
      last_checkpoint = std::chrono::steady_clock::now();
    }
  }
  return finished() ? "completed" : "interrupted";
}

template <int dim>
StepReport Simulation<dim>::take_step()
{
  const StepPlanner planner_before = planner;
  const StopMemory seen_before = seen, seen_in_stage = path.memory();
  try
  {
    StepReport report = model.advance(planner.limit(model.time(), next_target()));
    planner.taken(report.dt);
    // What ends the run or a stage is measured in a state that may be written, and so is the end.
    settle_if_written(report);
    stop.note(run_state(), seen);
    path.note(planner.slack());
    settle_if_written(report);
    return report;
  }
  catch (...)
  {
    planner = planner_before;
    seen = seen_before;
    path.take_back(seen_in_stage);
    step_given_up = true;
    throw;
  }
}

template <int dim>
double Simulation<dim>::next_target() const
{
  const double end = stop.end_time() > 0 ? stop.end_time() : std::numeric_limits<double>::infinity();
  const double end_of_stage = path.end_time() > 0 ? path.end_time() : std::numeric_limits<double>::infinity();
  return std::min({end, end_of_stage, field_schedule.next(), snapshot_schedule.next()});
}

template <int dim>
bool Simulation<dim>::finished(const double of_run) const
{
  return of_run >= 1. || (!path.empty() && path.is_last() && stage_is_done(path, planner.slack()));
}

template <int dim>
double Simulation<dim>::run_done() const
{
  return stop.fraction_done(run_state(), seen);
}

template <int dim>
double Simulation<dim>::fraction_done() const
{
  const double of_run = run_done();
  if (finished(of_run))
    return 1.;
  return path.empty() ? of_run : path.fraction_done(planner.slack(), of_run);
}

template <int dim>
RunStateIn<dim> Simulation<dim>::run_state() const
{
  return {model, walls_at_start, scene.loads, planner.slack(), 0., nullptr, stop.end_time() > 0.};
}

template <int dim>
void Simulation<dim>::settle_if_written(StepReport &report)
{
  if (model.step() % parameters.history_every == 0 || field_schedule.due(model.time(), planner.slack()) ||
      snapshot_schedule.due(model.time(), planner.slack()) || finished() || next_stage_is_due())
    model.settle(report);
}

template <int dim>
bool Simulation<dim>::next_stage_is_due() const
{
  return !path.is_last() && stage_is_done(path, planner.slack());
}

template <int dim>
void Simulation<dim>::end_stage()
{
  if (waiting.parts.stage)
  {
    waiting.parts.stage = false;
    try
    {
      write_state(stage_path(parameters.output_directory, path.name()));
    }
    catch (...)
    {
      waiting.parts.stage = true;
      throw;
    }
  }
  begin_next_stage();
}

template <int dim>
void Simulation<dim>::begin_next_stage()
{
  const std::string ended = path.name();
  path.next(run_done());
  progress.next_stage();
  log.both() << "stage " << ended << " ends at t = " << model.time() << " s, stage " << path.name()
             << " begins\n";
  write_checkpoint();
}

template class Simulation<2>;
template class Simulation<3>;
} // namespace softgrain
