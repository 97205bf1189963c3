// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_command_line_h
#define softgrain_app_command_line_h

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace softgrain
{
class Input;

/**
 * @brief What the user typed after `softgrain`.
 *
 * Exit codes: 0 done, 1 the computation failed, 2 bad input, 3 interrupted and saved. Errors are lines on
 * stderr, one for each; of mistakes in a parameter file there may be several.
 */
class CommandLine
{
public:
  /// @return the exit code when there is nothing left to do: help, version, a mistake.
  std::optional<int> parse(int argc, const char *const *argv);

  /// Whether the command computes or at least builds a model, for which main() prepares MPI.
  bool builds_model() const { return command == Command::run || command == Command::check; }

  /// Does what the user asked for.
  /// @return the exit code
  int execute();

private:
  enum class Command
  {
    run,
    check,
    parameters,
    measure,
    script
  };

  struct Words;
  /// Options of all commands that read a parameter file.
  void add_input(CLI::App &command, Words &words);
  void add_run(CLI::App &app, Words &words);
  void add_check(CLI::App &app, Words &words);
  void add_lists(CLI::App &app);
  /// Takes what was typed. @return an exit code where something is missing
  std::optional<int> take(const CLI::App &chosen, const Words &words);

  /// The checkpoint from which a run is to go on; empty: it begins at its start.
  /// @throw InputError when it may not
  std::string where_to_begin(const Input &input, const std::string &folder) const;
  /// Reads the input on all ranks, and chooses the number of threads.
  std::unique_ptr<Input> read_input() const;
  /// @return whether it came to its end
  bool run() const;
  void check() const;
  void print_parameters() const;
  void measure() const;

  Command command = Command::run;
  std::string parameter_file;
  std::vector<std::string> assignments; ///< those of --output and --threads included
  unsigned int n_ranks = 0;             ///< that check is to say the cost of; 0: none
  double trial_seconds = 0.;            ///< that check is to compute for; 0: not at all
  bool build = false;                   ///< check is to make packing and model
  bool no_libraries = false;            ///< check is to load no code of others
  bool restart = false;
  bool overwrite = false;
  std::string checkpoint; ///< empty: the newest
  std::string model;
  unsigned int dimension = 2; ///< of the scene whose parameters are printed
  std::string format = "prm";
  std::string directory; ///< of snapshots to measure
  std::string table;     ///< of measures; empty: in the same folder
  std::vector<std::string> measures;
  bool list_measures = false;
  std::string script;
  std::vector<std::string> script_arguments;
};
} // namespace softgrain

#endif
