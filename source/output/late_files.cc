// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/late_files.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace softgrain
{
namespace
{
/// Waits side by side are merged by the system into few: eight take a tenth of the time of one after the
/// other.
constexpr std::size_t most_at_once = 8;

/// Brings files or folders to the disk, several at once, by what brings one. @return a refusal, in words
std::optional<std::string> bring_all(const std::vector<std::string> &files,
                                     void (*bring)(const std::string &))
{
  std::atomic<std::size_t> next{0};
  const std::size_t n_threads = std::min(files.size(), most_at_once);
  std::vector<std::optional<std::string>> refusals(files.size());
  const auto work = [&]()
  {
    for (std::size_t n = next++; n < files.size(); n = next++)
      try
      {
        std::error_code missing;
        if (std::filesystem::exists(files[n], missing))
          bring(files[n]);
      }
      catch (const std::exception &error)
      {
        refusals[n] = error.what();
      }
  };
  std::vector<std::thread> threads;
  try
  {
    for (std::size_t n = 1; n < n_threads; ++n)
      threads.emplace_back(work);
  }
  catch (const std::system_error &)
  {
    // The system gives no more threads: those that are there do it.
  }
  work();
  for (std::thread &thread : threads)
    thread.join();
  const auto refused =
      std::find_if(refusals.begin(), refusals.end(), [](const auto &one) { return one.has_value(); });
  return refused == refusals.end() ? std::nullopt : *refused;
}
} // namespace

void LateFiles::bring_to_disk()
{
  std::set<std::string> folders;
  for (const std::string &path : paths)
    folders.insert(folder_of_file(path));
  if (!refused)
    refused = bring_all({paths.begin(), paths.end()}, bring_file_to_disk);
  if (!refused)
    refused = bring_all({folders.begin(), folders.end()}, bring_folder_to_disk);
  if (refused)
    throw ComputationError(*refused);
  paths.clear();
}
} // namespace softgrain
