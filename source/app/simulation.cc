// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/measure_table.h>
#include <softgrain/app/output_folder.h>
#include <softgrain/app/simulation.h>
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/parallel.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/summary.h>
#include <softgrain/scene/contact_pairs.h>

#include <deal.II/base/config.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <ostream>

namespace softgrain
{
namespace
{
double seconds_since(const std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace

Simulation::Simulation(const Input &input, Model<2> &model, const RunLock &lock, std::ostream &terminal)
    : scene(input.scene())
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
    , measures(parameters.measures, uniform_friction(scene))
    , measure_table(parameters.output_directory, measure_table_name)
    , field_schedule(parameters.fields_every)
    , snapshot_schedule(parameters.snapshots_every)
    , planner(model.equal_steps())
    , path(input.stages(), model, scene.gravity)
{
}

void Simulation::restart(StateReader &checkpoint,
                         const std::string &file_name,
                         const std::vector<std::string> &changes)
{
  path.load(checkpoint);
  model.load(checkpoint);
  statistics.load(checkpoint);
  planner.set_natural_step(checkpoint.read_doubles("driver/natural_step").at(0));
  field_schedule.skip_to(model.time(), planner.slack());
  snapshot_schedule.skip_to(model.time(), planner.slack());
  seen = load_stop_memory(checkpoint, stop_seen_name);
  ranks.at_first(
      [this]()
      {
        history.resume(model.step());
        fields.resume(model.time());
        snapshots.resume(model.time());
        if (!measures.measures().empty())
        {
          measure_table.resume(model.step(), measure_columns(measures.measures()));
          remember_snapshots(measures, parameters.output_directory, model.time());
        }
        log.open(parameters.output_directory, true);
      });
  restarted = true;
  for (const std::string &change : changes)
    log.both() << "changed since the checkpoint: " << change << '\n';
  log.both() << "going on from " << file_name << ", step " << model.step() << '\n';
}

std::string Simulation::run()
{
  const InterruptGuard interrupt;
  try
  {
    start_files();
    print_head();
    const std::string status = loop();
    progress.finish();
    write_checkpoint();
    write_summary(status);
    print_end(status);
    return status;
  }
  catch (const ComputationError &error)
  {
    ranks.fail_alike(error.what());
    progress.finish();
    const std::string cause = cause_of(error);
    const std::string message = cause + save_after_failure(cause);
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

std::string Simulation::cause_of(const ComputationError &error) const
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

std::string Simulation::save_after_failure(const std::string &message)
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
  note_failure();
  return text;
}

void Simulation::note_failure()
{
  if (!ranks.first())
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

void Simulation::start_files()
{
  const std::filesystem::path folder = parameters.output_directory;
  ranks.at_first(
      [&]()
      {
        if (!restarted)
        {
          remove_old_results(folder.string());
          log.open(folder.string(), false);
        }
        write_file_atomically((folder / "parameters.prm").string(), effective_parameters);
      });
  write_summary("running");
  if (!restarted)
    path.begin();
  // Another folder than that of the checkpoint begins with the state that the run goes on from.
  if (!restarted || ranks.any(ranks.first() && history.is_new()))
  {
    write_history(StepReport());
    write_pictures(field_schedule.active(), snapshot_schedule.active());
  }
}

std::string Simulation::loop()
{
  progress.start();
  if (path.was_at_end_of_stage() && !finished() && next_stage_is_due())
    begin_next_stage();
  auto last_checkpoint = std::chrono::steady_clock::now();
  StepReport report;
  while (!finished() && !interruption_requested())
  {
    if (const std::string moved = model.share_out_anew(); !moved.empty())
      log.file() << moved << std::endl;
    try
    {
      report = take_step();
    }
    catch (const Interrupted &)
    {
      break; // all is as it was before the step
    }
    statistics.add_step(report);
    write_due_output(report);
    if (next_stage_is_due())
      end_stage(report);
    progress.update(model.time(), model.step(), report, fraction_done());
    // The clock of the first rank counts.
    if (parameters.checkpoint_minutes > 0 &&
        ranks.any(ranks.first() && seconds_since(last_checkpoint) > 60 * parameters.checkpoint_minutes))
    {
      write_checkpoint();
      write_summary("running");
      last_checkpoint = std::chrono::steady_clock::now();
    }
  }
  if (!finished())
    return "interrupted"; // and nothing is written that an uninterrupted run would not write
  // The end of a run is always on record, whatever the intervals.
  if (last_history_step != model.step() && report.dt > 0)
    write_history(report);
  if (last_picture_step != model.step() && report.dt > 0)
    write_pictures(field_schedule.active(), snapshot_schedule.active());
  return "completed";
}

StepReport Simulation::take_step()
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
    throw;
  }
}

double Simulation::next_target() const
{
  const double end = stop.end_time() > 0 ? stop.end_time() : std::numeric_limits<double>::infinity();
  const double end_of_stage = path.end_time() > 0 ? path.end_time() : std::numeric_limits<double>::infinity();
  return std::min({end, end_of_stage, field_schedule.next(), snapshot_schedule.next()});
}

bool Simulation::finished(const double of_run) const
{
  return of_run >= 1. || (!path.empty() && path.is_last() && path.stage_is_done(planner.slack()));
}

double Simulation::run_done() const
{
  return stop.fraction_done(run_state(), seen);
}

double Simulation::fraction_done() const
{
  const double of_run = run_done();
  if (finished(of_run))
    return 1.;
  return path.empty() ? of_run : path.fraction_done(planner.slack(), of_run);
}

RunState Simulation::run_state() const
{
  return {model, walls_at_start, planner.slack(), 0., scene.gravity};
}

void Simulation::settle_if_written(StepReport &report)
{
  if (model.step() % parameters.history_every == 0 || field_schedule.due(model.time(), planner.slack()) ||
      snapshot_schedule.due(model.time(), planner.slack()) || finished() || next_stage_is_due())
    model.settle(report);
}

bool Simulation::next_stage_is_due() const
{
  return !path.is_last() && path.stage_is_done(planner.slack());
}

void Simulation::end_stage(const StepReport &report)
{
  if (last_history_step != model.step())
    write_history(report);
  if (last_picture_step != model.step())
    write_pictures(field_schedule.active(), snapshot_schedule.active());
  write_state(stage_path(parameters.output_directory, path.name()));
  begin_next_stage();
}

void Simulation::begin_next_stage()
{
  const std::string ended = path.name();
  path.next(run_done());
  progress.next_stage();
  log.both() << "stage " << ended << " ends at t = " << model.time() << " s, stage " << path.name()
             << " begins\n";
  write_checkpoint();
}

void Simulation::print_head()
{
  log.both() << "softgrain " << SOFTGRAIN_VERSION << " (deal.II " << DEAL_II_PACKAGE_VERSION << ", "
             << (ranks.alone() ? "" : std::to_string(ranks.number()) + " ranks, each with ") << n_threads()
             << " threads)\n"
             << "model " << model.name() << ", results in " << parameters.output_directory << '\n';
  SizeReport report = model.size_report();
  report.insert(report.end(), expected.begin(), expected.end());
  print_size_report(log.both(), report);
  log.both() << std::flush;
}

void Simulation::print_end(const std::string &status)
{
  const Summary summary = statistics.summary(status, model);
  log.both() << status << " at t = " << model.time() << " s after " << model.step() << " steps and "
             << duration_in_words(summary.wall_seconds) << " (" << std::setprecision(3)
             << summary.microseconds_per_point_step() << " us per point and step)\n";
  if (status == "interrupted")
    log.both() << "the state is saved in " << checkpoint_path(parameters.output_directory, model.step())
               << "; the same command with --restart goes on from there\n";
  double total = 0;
  for (const auto &phase : summary.phases)
    total += phase.second;
  for (const auto &[name, seconds] : summary.phases)
    log.both() << "  " << std::left << std::setw(30) << name << std::right << std::fixed
               << std::setprecision(2) << std::setw(10) << seconds << " s" << std::setprecision(1)
               << std::setw(7) << (total > 0 ? 100 * seconds / total : 0.) << " %\n";
  log.both() << std::defaultfloat << std::setprecision(6);
  print_ranks();
  log.both() << std::flush;
}

void Simulation::print_ranks()
{
  if (ranks.alone())
    return;
  RankTimes here = model.rank_times();
  const RankTimes output = ranks.taken();
  here.own += output.own;
  here.waiting += output.waiting;
  here.messages += output.messages;
  // Of the whole program: what is no rank's own is done alike by all.
  const double alike_here = std::max(0., processor_seconds() - here.own - here.spinning - output.spinning);
  double own = 0., busiest = 0., alike = 0., waiting = 0.; // means, but for the busiest
  for (const std::vector<double> &one : ranks.of_all({here.own, alike_here, here.waiting}))
  {
    own += one[0] / ranks.number();
    busiest = std::max(busiest, one[0]);
    alike += one[1] / ranks.number();
    waiting += one[2] / ranks.number();
  }
  log.both() << std::fixed << std::setprecision(2) << "  processor seconds of a rank: its own work " << own
             << " (the busiest " << busiest << "), what all do alike " << alike << "\n  it waits for others "
             << waiting << " s, in " << here.messages << " exchanges of " << std::setprecision(1)
             << here.bytes / 1e6 << " MB\n"
             << std::defaultfloat << std::setprecision(6);
}

void print_size_report(std::ostream &out, const SizeReport &report)
{
  std::size_t width = 0;
  for (const auto &line : report)
    width = std::max(width, line.first.size());
  for (const auto &[name, value] : report)
    out << "  " << name << std::string(width - name.size() + 2, ' ') << value << '\n';
}
} // namespace softgrain
