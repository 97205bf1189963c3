// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/check_report.h>
#include <softgrain/app/command_line.h>
#include <softgrain/app/error_lines.h>
#include <softgrain/app/input.h>
#include <softgrain/app/machine_speed.h>
#include <softgrain/app/measure_table.h>
#include <softgrain/app/outlook.h>
#include <softgrain/app/output_folder.h>
#include <softgrain/app/python_script.h>
#include <softgrain/app/run_lock.h>
#include <softgrain/app/simulation.h>
#include <softgrain/app/trial.h>
#include <softgrain/app/usage.h>
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/parallel.h>
#include <softgrain/base/preparation.h>
#include <softgrain/base/ranks.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/scene/contact_pairs.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>

namespace softgrain
{
namespace
{
constexpr int failed = 1;
constexpr int bad_input = 2;
constexpr int interrupted = 3;

const char *const exit_codes =
    "Exit codes: 0 done, 1 the computation failed (the last good state is saved), 2 bad input (nothing is "
    "touched), 3 interrupted by a signal (the state is saved; --restart goes on).";
} // namespace

/// Options that parameters or words after them stand for.
struct CommandLine::Words
{
  std::string output, threads;
  CLI::Option *restart = nullptr, *trial = nullptr;
};

void CommandLine::add_input(CLI::App &command, Words &words)
{
  command.add_option("FILE", parameter_file, "parameter file: .prm or .json")->required();
  command
      .add_option("--set", assignments,
                  "change one parameter: \"Section/Subsection/Name=value\"; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--output", words.output, "folder for the results; default: output/NAME for NAME.prm");
  command.add_option("--threads", words.threads, "number of threads; 0: one per core");
}

void CommandLine::add_run(CLI::App &app, Words &words)
{
  CLI::App &command = *app.add_subcommand("run", "compute the scene of a parameter file");
  add_input(command, words);
  words.restart = command
                      .add_option("--restart", checkpoint,
                                  "go on from a checkpoint; without a file name: from the newest one")
                      ->expected(0, 1);
  command.footer(exit_codes);
  command.add_flag("--overwrite", overwrite, "begin anew in the folder of another run; that run is lost")
      ->excludes(words.restart);
}

void CommandLine::add_check(CLI::App &app, Words &words)
{
  CLI::App &command =
      *app.add_subcommand("check", "read a parameter file, print the size of the job, compute nothing");
  add_input(command, words);
  command.add_flag("--build", build,
                   "make the packing and the model, which may take long, to say exact sizes");
  words.trial =
      command
          .add_option("--try", trial_seconds,
                      "compute for so many seconds (default 10), coarser if need be, to say what the "
                      "run takes; nothing is written")
          ->expected(0, 1)
          ->check(CLI::Range(0.1, 1e6));
  command.add_flag("--no-libraries", no_libraries,
                   "load no code that the file names; what only its libraries know is listed, not refused");
  command.add_option("--ranks", n_ranks, "say also what falls to one rank of so many, under mpirun")
      ->check(CLI::Range(1u, 1000000u));
}

void CommandLine::add_lists(CLI::App &app)
{
  CLI::App &of_parameters = *app.add_subcommand("parameters", "print every parameter");
  of_parameters.add_option("--model", model, "model whose parameters are printed: mpm (default) or bpm");
  of_parameters.add_option("--dimension", dimension, "2 (default), or 3: those of a scene in space");
  of_parameters.add_option("--format", format, "prm (default), json or md")
      ->check(CLI::IsMember({"prm", "json", "md"}));
  CLI::App &of_measures = *app.add_subcommand("measure", "compute measures from the snapshots of a run");
  of_measures.add_option("DIR", directory, "output folder that holds snapshots.h5");
  of_measures.add_option("--output", table, "table to write; default: DIR/measures.csv");
  of_measures.add_option("--measures", measures, "names, separated by commas; default: all")->delimiter(',');
  of_measures.add_flag("--list", list_measures, "print the names of the measures");
}

namespace
{
/// Scripts have options of their own, --help too.
void add_scripts(CLI::App &app)
{
  for (const auto &[name, help] :
       {std::pair("render", "draw pictures of a run: softgrain render DIR"),
        std::pair("plot", "draw curves from the history of runs: softgrain plot DIR..."),
        std::pair("report", "make one page of runs, to look at in a browser: softgrain report DIR..."),
        std::pair("study",
                  "run a scene with many settings and show what accuracy costs: softgrain study FILE"),
        std::pair("figures", "draw the figures of a publication from runs: softgrain figures NAME DIR...")})
  {
    CLI::App *sub = app.add_subcommand(name, help)->prefix_command();
    sub->set_help_flag();
  }
}
} // namespace

std::optional<int> CommandLine::take(const CLI::App &chosen, const Words &words)
{
  if (!words.output.empty())
    assignments.push_back("Output directory=" + words.output);
  if (!words.threads.empty())
    assignments.push_back("Threads=" + words.threads);
  restart = !words.restart->empty();
  if (*words.trial && words.trial->as<std::string>().empty())
    trial_seconds = 10.;
  const std::map<std::string, Command> commands = {{"run", Command::run},
                                                   {"check", Command::check},
                                                   {"parameters", Command::parameters},
                                                   {"measure", Command::measure}};
  const auto known = commands.find(chosen.get_name());
  command = known != commands.end() ? known->second : Command::script;
  if (command == Command::measure && directory.empty() && !list_measures)
    return report_error("measure: name the output folder of a run, or --list", bad_input);
  if (command == Command::script)
  {
    script = chosen.get_name();
    script_arguments = chosen.remaining();
  }
  return std::nullopt;
}

std::optional<int> CommandLine::parse(const int argc, const char *const *argv)
{
  CLI::App app(
      "softgrain computes how packings of soft particles deform, by the material point method (mpm) or by "
      "bonded particles (bpm).",
      "softgrain");
  app.set_version_flag("--version", std::string("softgrain ") + SOFTGRAIN_VERSION,
                       "print the version and exit");
  app.set_help_flag("-h,--help", "print this help and exit");
  app.require_subcommand(1);
  app.footer(exit_codes);
  Words words;
  add_run(app, words);
  add_check(app, words);
  add_lists(app);
  add_scripts(app);
  add_examples(app);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success &done)
  {
    return app.exit(done);
  }
  catch (const CLI::ParseError &error)
  {
    const std::vector<std::string> typed(argv + 1, argv + argc);
    return report_error(explain_mistake(app, typed, error.what()) + " (softgrain --help shows examples)",
                        bad_input);
  }
  return take(*app.get_subcommands().front(), words);
}

int CommandLine::execute()
{
  try
  {
    switch (command)
    {
    case Command::run:
      return run() ? 0 : interrupted;
    case Command::check:
      check();
      break;
    case Command::parameters:
      print_parameters();
      break;
    case Command::measure:
      measure();
      break;
    case Command::script:
      run_python_script(script, script_arguments);
    }
    // What was asked for is what these print.
    if (command != Command::script && !(std::cout << std::flush))
      throw ComputationError("the terminal or file that should get the answer cannot be written");
    return 0;
  }
  catch (const InputErrors &errors)
  {
    return report_errors(errors.lines(), bad_input);
  }
  catch (const InputError &error)
  {
    return report_error(error.what(), bad_input);
  }
  catch (const std::bad_alloc &)
  {
    return report_error("out of memory; use fewer points or a coarser grid", failed);
  }
  catch (const std::exception &error)
  {
    return report_error(short_message(error), failed);
  }
}

namespace
{
/// @throw InputError for a model that one rank alone can run
void check_works_on_ranks(const Input &input, const unsigned int n_ranks)
{
  const std::string model = input.run().model;
  const auto factory = Registry<ModelFactory>::instance().create(model);
  const bool in_space = input.dimension() == 3;
  if (!(in_space ? factory->works_on_ranks_in_space() : factory->works_on_ranks()))
    throw InputError("'Model' = '" + model + (in_space ? "' with 'Dimension' = '3'" : "'") +
                     " runs on one rank, not on " + std::to_string(n_ranks) +
                     ": leave mpirun out and choose the number of threads with --threads");
}
} // namespace

std::unique_ptr<Input> CommandLine::read_input() const
{
  const Ranks ranks;
  std::unique_ptr<Input> input;
  ranks.together(
      [&]()
      {
        input = std::make_unique<Input>(parameter_file, assignments,
                                        no_libraries ? Input::Libraries::leave_out : Input::Libraries::load);
        if (!ranks.alone())
          check_works_on_ranks(*input, ranks.number());
      });
  // With several ranks deal.II has shared the cores of a machine out already.
  if (ranks.alone() || input->run().threads != 0)
    set_n_threads(input->run().threads);
  return input;
}

namespace
{
/// A model is driven to its end. @return whether it came there
template <int dim, class Prepare>
bool drive(const Input &input, Model<dim> &model, const RunLock &lock, const Prepare &prepare)
{
  std::ostream silence(nullptr);
  Simulation<dim> simulation(input, model, lock, Ranks().first() ? std::cout : silence);
  prepare(simulation);
  return simulation.run() == "completed";
}
} // namespace

std::string CommandLine::where_to_begin(const Input &input, const std::string &folder) const
{
  if (!restart)
  {
    check_may_begin_anew(folder, overwrite);
    return "";
  }
  // A run that was killed before its first checkpoint goes on from its start.
  if (checkpoint.empty() && has_begun_without_checkpoint(folder, input.effective_parameters()))
    return "";
  const std::string file = checkpoint.empty() ? latest_checkpoint(folder) : checkpoint;
  check_may_go_on(folder, file);
  return file;
}

bool CommandLine::run() const
{
  const Ranks ranks;
  const PreparationLog telling(ranks.first());
  if (!ranks.alone())
    await_telling_of_interruption();
  const std::unique_ptr<Input> read = read_input();
  Input &input = *read;
  const std::string folder = input.run().output_directory;
  const RunLock lock(folder, ranks);
  // All that may be refused comes before the model, which may take long to build.
  std::unique_ptr<CheckpointReader> state;
  std::string state_file;
  std::vector<std::string> changes;
  ranks.at_first([&]() { state_file = where_to_begin(input, folder); });
  // The next thing may take long: whoever waits knows that it has begun.
  if (ranks.first())
    std::cout << head_of_log(input.run(), ranks) << std::flush;
  state_file = ranks.share(state_file, 0);
  const bool goes_on = restart && !state_file.empty();
  ranks.together(
      [&]()
      {
        if (!goes_on)
          return;
        state = std::make_unique<CheckpointReader>(state_file);
        input.complete_scene();
        changes = input.check_restart(*state, state_file);
      });
  const std::optional<RunOutline> outline = outline_of(input);
  const std::optional<Forecast> forecast = outline ? input.estimates().forecast(*outline) : std::nullopt;
  ranks.together([&]() { input.complete_scene(); });
  // A run that goes on has written its packing when it began.
  if (!restart)
    ranks.at_first([&]() { input.save_packing(overwrite); });
  const auto prepare = [&](auto &simulation)
  {
    if (forecast)
    {
      SizeReport expected = {{"friction", friction_in_words(input.scene())}};
      const SizeReport cost = cost_report(*outline, *forecast, slowness_of_machine());
      expected.insert(expected.end(), cost.begin(), cost.end());
      for (const std::string &warning : forecast->warnings)
        expected.emplace_back("warning", warning);
      simulation.expect(expected);
    }
    if (outline)
      simulation.expect_stages(outline->stages);
    if (goes_on)
      simulation.restart(*state, state_file, changes);
    else if (restart)
      simulation.say("there is no checkpoint in " + folder + " yet: the run begins again at its start");
  };
  if (input.dimension() == 3)
    return drive(input, *input.create_model_in_space(), lock, prepare);
  return drive(input, *input.create_model(state.get()), lock, prepare);
}

void CommandLine::check() const
{
  const PreparationLog telling(Ranks().first());
  const std::unique_ptr<Input> read = read_input();
  Input &input = *read;
  if (n_ranks > 1)
    check_works_on_ranks(input, n_ranks);
  if (!input.left_out().unknown.empty())
  {
    if (Ranks().first())
      print_left_out(std::cout, input);
    return;
  }
  std::optional<RunOutline> outline = outline_of(input);
  std::optional<Forecast> forecast = outline ? input.estimates().forecast(*outline) : std::nullopt;
  std::optional<Trial> trial;
  if (trial_seconds > 0. && input.dimension() == 3)
    throw InputError(
        "'--try' is not allowed with 'Dimension' = '3': what a run takes is foretold in the plane");
  if (trial_seconds > 0. && !Ranks().alone())
    throw InputError("'--try' works on one rank: leave mpirun out");
  if (trial_seconds > 0.)
    trial = try_out(input, outline, forecast, trial_seconds);
  std::unique_ptr<AnyModel> model;
  // What is built in a moment is built: that finds more mistakes.
  if (input.dimension() == 3)
    model = input.create_model_in_space();
  else if (build || !forecast || forecast->is_soon_built())
    model = input.estimates().model();
  if (Ranks().first())
    print_check_report(std::cout, input, outline, forecast, model.get(), trial ? &*trial : nullptr, n_ranks);
}

void CommandLine::measure() const
{
  if (!list_measures)
    return measure_snapshots(directory, table, measures, std::cout);
  const Registry<Measure> &known = Registry<Measure>::instance();
  SizeReport lines;
  for (const std::string &name : known.names())
    lines.emplace_back(name, known.description(name));
  print_size_report(std::cout, lines);
}
} // namespace softgrain
