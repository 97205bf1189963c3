// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/usage.h>
#include <softgrain/base/nearest_name.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <tuple>

namespace softgrain
{
namespace
{
const char *const program_examples =
    R"(Examples:
  softgrain run scene.prm                       compute; results go to output/scene
  softgrain run scene.prm --set "Mesh/Cell size=2e-4" --output output/fine
  softgrain run scene.prm --restart             go on from the newest checkpoint
  softgrain check scene.prm                     read the file, tell size, time and memory of the job
  softgrain render output/scene                 draw the last state
  softgrain plot output/scene output/fine       draw curves of two runs
  softgrain report output/scene                 make a page with all of it, report.html
  softgrain study study.prm                     show what accuracy costs, for a scene and its settings
  softgrain parameters --format md              list every parameter

`softgrain COMMAND --help` tells the options of a command. The manual is in doc/index.md.)";

const char *const run_examples =
    R"(Examples:
  softgrain run scene.prm --threads 4
  softgrain run scene.prm --set "Contact/Friction=0.5" --set "Stop/End time=1e-3" --output output/rough
  softgrain run scene.prm --restart
  softgrain run scene.prm --restart output/scene/state-000000120.h5)";

const char *const check_examples =
    R"(Examples:
  softgrain check scene.prm
  softgrain check scene.prm --build             make packing and bodies too, for exact sizes
  softgrain check scene.prm --set "Mesh/Cell size=1e-4")";

const char *const parameters_examples =
    R"(Every parameter with its default, what is allowed and what it means. NAME stands for the name of a
material, body or wall.

Examples:
  softgrain parameters                          a parameter file with comments, for mpm
  softgrain parameters --model bpm --format md  tables in Markdown
  softgrain parameters --format json            for programs; can be read as a parameter file)";

const char *const measure_examples =
    R"(Examples:
  softgrain measure --list
  softgrain measure output/scene
  softgrain measure output/scene --measures stress,coordination --output stress.csv)";

std::vector<std::string> command_names(const CLI::App &app)
{
  std::vector<std::string> names;
  for (const CLI::App *command : app.get_subcommands([](const CLI::App *) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string did_you_mean(const std::string &word, const std::vector<std::string> &names)
{
  const std::string near = nearest_name(word, names);
  return near.empty() ? "" : " (did you mean '" + near + "'?)";
}

std::vector<std::string> option_names(const CLI::App &command)
{
  std::vector<std::string> names;
  for (const CLI::Option *option : command.get_options())
    for (const std::string &name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}
} // namespace

void add_examples(CLI::App &app)
{
  for (const auto &[command, option, value] :
       {std::tuple("run", "FILE", ""), std::tuple("run", "--set", "PATH=VALUE"),
        std::tuple("run", "--output", "DIR"), std::tuple("run", "--threads", "N"),
        std::tuple("run", "--restart", "[CHECKPOINT]"), std::tuple("check", "FILE", ""),
        std::tuple("check", "--set", "PATH=VALUE"), std::tuple("check", "--output", "DIR"),
        std::tuple("check", "--threads", "N"), std::tuple("parameters", "--model", "MODEL"),
        std::tuple("parameters", "--format", "FORMAT"), std::tuple("measure", "DIR", ""),
        std::tuple("measure", "--output", "FILE"), std::tuple("measure", "--measures", "NAME,...")})
    app.get_subcommand(command)->get_option(option)->type_name(value);
  // A footer that is there already comes after the examples.
  const auto add = [](CLI::App &command, const std::string &examples)
  {
    const std::string old = command.get_footer();
    command.footer(examples + (old.empty() ? "" : "\n\n" + old));
  };
  add(app, program_examples);
  for (const auto &[name, examples] :
       {std::pair("run", run_examples), std::pair("check", check_examples),
        std::pair("parameters", parameters_examples), std::pair("measure", measure_examples)})
    add(*app.get_subcommand(name), examples);
}

std::string
explain_mistake(const CLI::App &app, const std::vector<std::string> &words, const std::string &otherwise)
{
  const auto is_option = [](const std::string &word) { return word.size() > 1 && word[0] == '-'; };
  const auto command = std::find_if_not(words.begin(), words.end(), is_option);
  const std::vector<std::string> commands = command_names(app);
  if (command == words.end())
    return words.empty() ? "no command after '" + app.get_name() + "'; there are " + join(commands)
                         : otherwise;
  if (std::find(commands.begin(), commands.end(), *command) == commands.end())
    return "'" + app.get_name() + "' has no command '" + *command + "'" + did_you_mean(*command, commands) +
           "; there are " + join(commands);

  const CLI::App &chosen =
      *app.get_subcommands([&](const CLI::App *sub) { return sub->get_name() == *command; }).front();
  const std::vector<std::string> rest(command + 1, words.end());
  if (!command_names(chosen).empty())
    return explain_mistake(chosen, rest, otherwise);
  const std::vector<std::string> options = option_names(chosen);
  for (const std::string &word : rest)
  {
    const std::string name = word.substr(0, word.find('='));
    if (name.rfind("--", 0) == 0 && std::find(options.begin(), options.end(), name) == options.end())
      return "'" + *command + "' has no option '" + name + "'" + did_you_mean(name, options) +
             "; there are " + join(options);
  }
  return otherwise;
}
} // namespace softgrain
