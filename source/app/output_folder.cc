// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/output_folder.h>
#include <softgrain/app/run_lock.h>
#include <softgrain/app/run_log.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/snapshot_file.h>

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
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
  const std::string what = "'Output directory' = '" + directory + "' ";
  std::error_code error;
  fs::path existing = fs::absolute(directory).lexically_normal();
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
  const std::string unfinished = unfinished_run(directory);
  if (unfinished.empty() || overwrite)
    return;
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

void remove_old_results(const std::string &directory)
{
  remove_pictures(directory);
  remove_snapshots(directory);
  for (const std::string &path : checkpoint_paths(directory))
    if (is_checkpoint(path))
      fs::remove(path);
  for (const fs::path &path : content(directory))
  {
    const bool part = path.extension() == ".part";
    const std::string name = part ? path.stem().string() : path.filename().string();
    const bool own_name = std::find(single_files.begin(), single_files.end(), name) != single_files.end();
    if (own_name || (part && (is_checkpoint_name(name) || is_stage_name(name))) ||
        (!part && is_stage_name(name) && is_checkpoint(path)))
      fs::remove(path);
  }
}
} // namespace softgrain
