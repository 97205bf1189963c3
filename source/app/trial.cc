// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/machine_speed.h>
#include <softgrain/app/outlook.h>
#include <softgrain/app/output_schedule.h>
#include <softgrain/app/progress.h>
#include <softgrain/app/stage_path.h>
#include <softgrain/app/trial.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/geometry/shape.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <sstream>
#include <thread>
#include <vector>

namespace softgrain
{
namespace
{
/// Part of the time of a trial that a formula may ask for: it is often wrong by two.
constexpr double share = 0.5;
/// Part of the time of a trial that must be left for the scene itself, after a coarser one.
constexpr double least_left = 0.2;
/// Share of the way below which nothing is known of the number of steps.
constexpr double least_fraction = 0.02;
/// Share of the way from which on the scene itself says more than a coarser one that went all of it.
constexpr double enough_of_way = 0.3;
/// Time on the clock over that of the processor, at most.
constexpr double patience = 3.;

/// Ends a step that is under way when the time is up.
class Deadline
{
public:
  explicit Deadline(const double seconds)
      : watch(
            [this, seconds]()
            {
              std::unique_lock<std::mutex> lock(mutex);
              if (!wake.wait_for(lock, std::chrono::duration<double>(seconds), [this]() { return over; }))
                request_interruption();
            })
  {
  }
  ~Deadline()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      over = true;
    }
    wake.notify_one();
    watch.join();
    forget_interruption();
  }
  Deadline(const Deadline &) = delete;
  Deadline &operator=(const Deadline &) = delete;

private:
  std::mutex mutex;
  std::condition_variable wake;
  bool over = false;
  std::thread watch;
};

/// The steps of a run, as Simulation makes them, with nothing that is written.
class Way
{
public:
  Way(const Input &input, Model<2> &model)
      : input(input)
      , model(model)
      , walls_at_start(model.walls())
      , fields(input.run().fields_every)
      , snapshots(input.run().snapshots_every)
      , planner(model.equal_steps())
      , path(input.stages(), model, input.scene().loads)
  {
    path.begin();
  }

  double fraction_done() const
  {
    const double of_run = run_done();
    const bool stages_done = !path.empty() && path.is_last() && stage_is_done(path, planner.slack());
    if (of_run >= 1. || stages_done)
      return 1.;
    return path.empty() ? of_run : path.fraction_done(planner.slack(), of_run);
  }

  void expect(const std::vector<double> &stages) { path.expect(stages); }

  void step()
  {
    StepReport report = model.advance(planner.limit(model.time(), next_target()));
    planner.taken(report.dt);
    // A stop condition looks at states that may be written.
    settle_if_written(report);
    input.stop().note(state(), seen);
    path.note(planner.slack());
    settle_if_written(report);
    fields.reached(model.time(), planner.slack());
    snapshots.reached(model.time(), planner.slack());
    if (!path.empty() && !path.is_last() && stage_is_done(path, planner.slack()))
      path.next(run_done());
  }

private:
  RunState state() const
  {
    return {model, walls_at_start, input.scene().loads,         planner.slack(),
            0.,    nullptr,        input.stop().end_time() > 0.};
  }
  double run_done() const { return input.stop().empty() ? 0. : input.stop().fraction_done(state(), seen); }

  double next_target() const
  {
    const auto known = [](const double time)
    { return time > 0. ? time : std::numeric_limits<double>::infinity(); };
    return std::min({known(input.stop().end_time()), known(path.empty() ? 0. : path.end_time()),
                     fields.next(), snapshots.next()});
  }

  void settle_if_written(StepReport &report)
  {
    if (model.step() % input.run().history_every == 0 || fields.due(model.time(), planner.slack()) ||
        snapshots.due(model.time(), planner.slack()) || fraction_done() >= 1.)
      model.settle(report);
  }

  const Input &input;
  Model<2> &model;
  const std::vector<WallState<2>> walls_at_start;
  OutputSchedule fields, snapshots;
  StepPlanner planner;
  StagePath<2> path;
  StopMemory seen;
};

/// What the trial is to be of: the scene itself where it may be done in time, else as little coarser as will
/// do.
ParameterValues choose(Input &input, const RunOutline &outline, const double slowness, const double seconds)
{
  ParameterValues chosen;
  for (const double factor : {1., 1.25, 1.5, 2., 2.5, 3., 4.})
  {
    const ParameterValues changes = factor > 1. ? input.estimates().coarser(factor) : ParameterValues();
    if (factor > 1. && (changes.empty() || changes == chosen))
      break;
    chosen = changes;
    const std::optional<Forecast> forecast = input.estimates().forecast(outline, chosen);
    if (forecast && forecast->n_steps > 0. && slowness * forecast->seconds() < share * seconds)
      break;
  }
  return chosen;
}
} // namespace

std::string Trial::in_words() const
{
  std::ostringstream text;
  for (const auto &[name, value] : coarser)
    text << '\'' << name << "' = " << value << ", ";
  text << steps << " steps in " << duration_in_words(seconds) << " of processor time, ";
  const long percent = std::lround(100. * fraction);
  if (!failure.empty())
    text << "after " << percent << " % of the way it ended: " << failure;
  else if (fraction >= 1.)
    text << "to the end";
  else
    text << percent << " % of the way; ";
  if (failure.empty() && fraction < 1.)
  {
    text << (!rest_of.empty() ? "what comes as with"
             : has_corners ? "corners jam late: the last fifth of the way may take half of the time and more"
                           : "what comes may be another matter");
    for (const auto &[name, value] : rest_of)
      text << " '" << name << "' = " << value;
  }
  return text.str();
}

namespace
{
using Mark = Trial::Mark;

/**
 * What the whole way takes: the rest of it goes as the last third of the way so far.
 *
 * A shorter part would be one rearrangement or one jam, a longer one has steps in which nothing touched yet;
 * doc/results/forecast.md compares them.
 */
void expect_rest(Trial &trial)
{
  constexpr double last_part = 1. / 3.;
  trial.all_steps = trial.steps;
  trial.all_seconds = trial.seconds;
  if (trial.marks.empty() || trial.fraction < least_fraction)
    return;
  const auto since =
      std::find_if(trial.marks.rbegin(), trial.marks.rend(),
                   [&](const Mark &mark) { return mark.fraction <= (1. - last_part) * trial.fraction; });
  const double way = trial.fraction - since->fraction, parts_left = (1. - trial.fraction) / way;
  trial.all_steps += parts_left * (trial.steps - since->steps);
  trial.all_seconds += parts_left * (trial.seconds - since->seconds);
}

/// Steps of the scene with the changes of @p trial, until the end or until the time is up.
void go(
    Trial &trial, const Input &input, const RunOutline &outline, Model<2> &model, const double most_seconds)
{
  const double begin = processor_seconds();
  Way way(input, model);
  way.expect(outline.stages);
  // After every step: an interruption leaves what is known.
  while (way.fraction_done() < 1. && trial.seconds < most_seconds && !interruption_requested())
  {
    trial.marks.push_back({trial.fraction, static_cast<double>(trial.steps), trial.seconds});
    way.step();
    trial.steps = model.step();
    trial.time = model.time();
    trial.fraction = std::clamp(way.fraction_done(), 0., 1.);
    trial.seconds = processor_seconds() - begin;
    expect_rest(trial);
  }
}

/// Makes the model of a trial and goes its way, as far as that is possible.
void make(Trial &trial, Input &input, const RunOutline &outline, const double most_seconds)
{
  try
  {
    const double begin = processor_seconds();
    const std::unique_ptr<Model<2>> model = input.estimates().model(trial.coarser);
    trial.preparation = processor_seconds() - begin;
    go(trial, input, outline, *model, most_seconds);
  }
  catch (const Interrupted &)
  {
  }
  catch (const ComputationError &error)
  {
    trial.failure = error.what();
    // The steps before it were cut and cut again: they are no measure of what is left.
    if (trial.fraction > least_fraction)
    {
      trial.all_steps = trial.steps / trial.fraction;
      trial.all_seconds = trial.seconds / trial.fraction;
    }
  }
}

/// The rest of the way of @p trial takes what that of a coarser one took, in proportion to what both took so
/// far.
void go_on_as(Trial &trial, const Trial &coarser)
{
  const auto there =
      std::find_if(coarser.marks.begin(), coarser.marks.end(),
                   [&](const Mark &mark) { return mark.fraction >= trial.fraction && mark.seconds > 0.; });
  if (there == coarser.marks.end())
    return;
  trial.all_steps = trial.steps * coarser.steps / there->steps;
  trial.all_seconds = trial.seconds * coarser.seconds / there->seconds;
  trial.rest_of = coarser.coarser;
}
} // namespace

Trial try_out(Input &input,
              std::optional<RunOutline> &outline,
              std::optional<Forecast> &forecast,
              const double seconds)
{
  Trial trial;
  const double begin = processor_seconds();
  input.complete_scene();
  trial.packing = processor_seconds() - begin;
  // Now the bodies are known.
  outline = outline_of(input);
  if (outline)
    outline->to_pack = false;
  forecast = outline ? input.estimates().forecast(*outline) : std::nullopt;
  if (!forecast)
    throw InputError("'--try': what this scene takes cannot be judged");
  trial.coarser = choose(input, *outline, slowness_of_machine(), seconds);
  // Where other programs take their share of the processor, it may take longer.
  const Deadline deadline(patience * seconds);
  const std::vector<BodyDescription<2>> &bodies = input.scene().bodies;
  trial.has_corners =
      bodies.size() > 1 && std::any_of(bodies.begin(), bodies.end(),
                                       [](const BodyDescription<2> &body) { return !body.shape->round(); });
  make(trial, input, *outline, seconds);
  double duration = trial.fraction >= 1. ? trial.time : 0.;
  // One that came to its end has seen the whole way, the scene as it is knows what its steps take.
  if (const double left = seconds - trial.seconds;
      !trial.coarser.empty() && trial.fraction >= 1. && left > least_left * seconds)
  {
    Trial itself;
    itself.packing = trial.packing;
    itself.has_corners = trial.has_corners;
    make(itself, input, *outline, left);
    if (itself.fraction >= 1. || !itself.failure.empty())
      trial = itself;
    else if (itself.fraction > enough_of_way)
    {
      go_on_as(itself, trial);
      trial = itself;
    }
    if (trial.fraction >= 1.)
      duration = trial.time;
  }
  *forecast = learned_from(trial, *forecast, *input.estimates().forecast(*outline, trial.coarser));
  if (outline->duration == 0. && duration > 0.)
    outline->duration = duration;
  return trial;
}

Forecast learned_from(const Trial &trial, const Forecast &formula, const Forecast &of_trial)
{
  Forecast learned = formula;
  constexpr double measurable = 0.02; // of processor time [s]
  if (trial.preparation > measurable && of_trial.preparation > 0.)
    learned.preparation *= trial.preparation / of_trial.preparation;
  learned.preparation += trial.packing;
  if (trial.steps == 0)
    return learned;
  const bool is_known = trial.fraction > least_fraction;
  if (of_trial.step_seconds > 0.)
    learned.step_seconds *= (is_known ? trial.all_seconds / trial.all_steps : trial.seconds / trial.steps) /
                            of_trial.step_seconds;
  if (of_trial.n_steps > 0. && is_known)
    learned.n_steps *= trial.all_steps / of_trial.n_steps;
  else if (trial.fraction >= 1. && formula.step > 0.)
    learned.n_steps = trial.steps * std::max(1., of_trial.step / formula.step);
  return learned;
}
} // namespace softgrain
