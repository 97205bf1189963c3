// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_late_files_h
#define softgrain_output_late_files_h

#include <optional>
#include <set>
#include <string>

namespace softgrain
{
/**
 * @brief Files that have their names and are whole for every reader, but that a failure of power could still
 * take.
 *
 * To wait for the disk after each small file takes longer than to compute what is in it. So files that a
 * checkpoint does not need are noted here, and bring_to_disk() waits for all of them at once, just before the
 * checkpoint that says they are written.
 */
class LateFiles
{
public:
  void add(const std::string &path) { paths.insert(path); }

  /// Waits until all that were added are on the disk with their names, and forgets them. What somebody has
  /// removed since is left out. @throw ComputationError with the reason when the disk refuses, and from then
  /// on: what a file has lost is lost, so no checkpoint may say that it is there.
  void bring_to_disk();

private:
  std::set<std::string> paths;
  std::optional<std::string> refused; ///< what the disk has refused once, the system does not try again
};
} // namespace softgrain

#endif
