// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/output_folder.h>
#include <softgrain/app/run_lock.h>
#include <softgrain/app/run_log.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/snapshot_file.h>
#include <softgrain/parameters/parameter_file.h>

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <climits>
#include <filesystem>
#include <fstream>
#include <vector>

namespace softgrain
{
namespace fs = std::filesystem;

namespace
{
/// Every run leaves this one first of all, so it marks a folder as ours.
const char *const mark = "parameters.prm";

/// Longest name of a folder or file, on every file system that matters.
constexpr std::size_t longest_name = 255;
/// Room for the longest path in an output folder, of the checkpoint of a stage.
constexpr std::size_t room_for_files = 256;

/// Beside series of pictures, snapshots and checkpoints.
const std::vector<std::string> single_files = {mark, "history.csv", "measures.csv", "summary.json",
                                               run_log_name};

/// What is in a folder; nothing when it cannot be read.
std::vector<fs::path> content(const std::string &directory)
{
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(directory, error))
    paths.push_back(entry.path());
  return paths;
}

/// "running at t = 0.1 s, step 20", of a run that has not ended; nothing for one that has.
std::string unfinished_run(const std::string &directory)
{
  if (!fs::exists(fs::path(directory) / mark))
    return "";
  const std::string unknown = "it says nothing of its end";
  std::ifstream file(fs::path(directory) / "summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("status") || !summary["status"].is_string())
    return unknown;
  const std::string status = summary["status"];
  if (status == "completed")
    return "";
  const auto number = [&summary](const char *const key)
  { return summary.value(key, nlohmann::json()).dump(); };
  return "'" + status + "' at t = " + number("simulated_time_s") + " s, step " + number("steps");
}
} // namespace

void check_output_folder(const std::string &directory)
{
  constexpr std::size_t shown = 300; // letters that a line can bear
  const std::string what = "'Output directory' = '" +
                           (directory.size() > shown ? directory.substr(0, 40) + "..." : directory) + "' ";
  std::error_code error;
  fs::path existing = fs::absolute(directory).lexically_normal();
  for (const fs::path &name : existing)
    if (name.string().size() > longest_name)
      throw InputError(what + "cannot be made: '" + name.string().substr(0, 20) + "...' has " +
                       std::to_string(name.string().size()) + " letters, a name has at most " +
                       std::to_string(longest_name));
  if (existing.string().size() + room_for_files > PATH_MAX)
    throw InputError(what + "cannot be made: a whole path has at most " + std::to_string(PATH_MAX) +
                     " letters");
  while (!fs::exists(existing, error) && existing.has_parent_path() && existing != existing.root_path())
    existing = existing.parent_path();
  if (!fs::is_directory(existing, error))
    throw InputError(what + "cannot be made: '" + existing.string() + "' is not a folder");
  if (access(existing.c_str(), W_OK | X_OK) != 0)
    throw InputError(what + "cannot be written: no permission for '" + existing.string() + "'");
  if (!fs::is_directory(directory, error))
    return;
  const fs::directory_iterator files(directory, error);
  if (error)
    throw InputError(what + "cannot be read: " + error.message());
  if (files != fs::directory_iterator() && !fs::exists(fs::path(directory) / mark) &&
      !fs::exists(fs::path(directory) / RunLock::file_name))
    throw InputError(what + "holds other files (" + files->path().filename().string() +
                     " and maybe more): name a new or empty folder");
}

void check_may_begin_anew(const std::string &directory, const bool overwrite)
{
  const std::string what = "'Output directory' = '" + directory + "' ";
  for (const std::string &path : checkpoint_paths(directory))
    if (!is_checkpoint(path))
      throw InputError(
          what + "holds " + fs::path(path).filename().string() +
          ", which has the name of a checkpoint and is none of softgrain's: move it away, or name "
          "another folder");
  if (overwrite || !fs::exists(fs::path(directory) / mark))
    return;
  const std::string unfinished = unfinished_run(directory);
  if (unfinished.empty())
    throw InputError(
        what + "holds a finished run: add --overwrite to replace it, or name another folder with --output");
  if (newest_checkpoint(directory))
    throw InputError(what + "holds a run that has not ended (" + unfinished +
                     "): add --restart to go on with it, or --overwrite to lose it and begin anew");
  throw InputError(what + "holds a run that has not ended (" + unfinished +
                   ") and has no checkpoint: add --overwrite to lose it and begin anew");
}

void check_may_go_on(const std::string &directory, const std::string &checkpoint)
{
  fs::path origin = fs::path(checkpoint).parent_path();
  std::error_code error;
  if (fs::exists(fs::path(directory) / mark) &&
      !fs::equivalent(origin.empty() ? "." : origin, directory, error) && !error)
    throw InputError("'Output directory' = '" + directory + "' holds the results of another run than " +
                     checkpoint + ": name a new or empty folder");
}

bool has_begun_without_checkpoint(const std::string &directory, const std::string &effective_parameters)
{
  return checkpoint_paths(directory).empty() && !unfinished_run(directory).empty() &&
         read_text_file((fs::path(directory) / mark).string()) == effective_parameters;
}

namespace
{
/// A file of a run that goes by the name it is given; one that cannot be removed ends the run.
void remove_file(const fs::path &path)
{
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw ComputationError("cannot remove " + path.string() + ": " + error.message());
}

bool is_unfinished(const fs::path &path)
{
  const std::string name = path.stem().string();
  return path.extension() == ".part" &&
         (std::find(single_files.begin(), single_files.end(), name) != single_files.end() ||
          name == "fields.pvd" || name == "snapshots.h5" || is_checkpoint_name(name) || is_stage_name(name));
}

/// Whether a file in the folder for pictures has a name that `render` or `plot` gives: FIELD-NNNNNN.png,
/// FIELD.mp4, Y-against-X.png.
bool is_drawn(const fs::path &path)
{
  const std::string name = path.stem().string();
  const bool numbered = name.size() > 7 && name[name.size() - 7] == '-' &&
                        name.find_first_not_of("0123456789", name.size() - 6) == std::string::npos;
  return path.extension() == ".mp4" ||
         (path.extension() == ".png" && (numbered || name.find("-against-") != std::string::npos));
}

void remove_drawn(const fs::path &directory)
{
  const fs::path pictures = directory / "pictures";
  for (const fs::path &path : content(pictures.string()))
    if (is_drawn(path))
      remove_file(path);
  std::error_code error;
  fs::remove(pictures, error); // refuses when something else is in it
  remove_file(directory / "report.html");
}
} // namespace

void remove_unfinished_files(const std::string &directory)
{
  for (const fs::path &path : content(directory))
    if (is_unfinished(path))
      remove_file(path);
}

void remove_old_results(const std::string &directory)
{
  // First what a run could go on from: without its files that would be half a run.
  for (const std::string &path : checkpoint_paths(directory))
    if (is_checkpoint(path))
      remove_file(path);
  for (const fs::path &path : content(directory))
    if (is_stage_name(path.filename()) && is_checkpoint(path))
      remove_file(path);
  remove_drawn(directory);
  remove_pictures(directory);
  remove_snapshots(directory);
  remove_unfinished_files(directory);
  // The mark stays until the new run replaces it: until then the folder would seem to be somebody else's.
  for (const std::string &name : single_files)
    if (name != mark)
      remove_file(fs::path(directory) / name);
}
} // namespace softgrain
