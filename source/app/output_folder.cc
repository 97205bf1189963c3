// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/output_folder.h>
#include <softgrain/base/exceptions.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace softgrain
{
namespace fs = std::filesystem;

namespace
{
/// Every run leaves this one first of all, so it marks a folder as ours.
const char *const mark = "parameters.prm";

bool is_result(const fs::path &path)
{
  static const std::vector<std::string> names = {mark,         "history.csv", "measures.csv", "summary.json",
                                                 "fields.pvd", "fields",      "snapshots.h5", "snapshots"};
  const std::string name = path.filename().string();
  const bool is_state = name.compare(0, 6, "state-") == 0 && path.extension() == ".h5";
  return is_state || path.extension() == ".part" ||
         std::find(names.begin(), names.end(), name) != names.end();
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
  if (files != fs::directory_iterator() && !fs::exists(fs::path(directory) / mark))
    throw InputError(what + "holds other files (" + files->path().filename().string() +
                     " and maybe more): name a new or empty folder");
}

void make_fresh_output_folder(const std::string &directory)
{
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw InputError("'Output directory' = '" + directory + "' cannot be made: " + error.message());
  std::vector<fs::path> old;
  for (const fs::directory_entry &entry : fs::directory_iterator(directory))
    if (is_result(entry.path()))
      old.push_back(entry.path());
  for (const fs::path &path : old)
    fs::remove_all(path);
}
} // namespace softgrain
