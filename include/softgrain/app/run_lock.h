// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_run_lock_h
#define softgrain_app_run_lock_h

#include <softgrain/base/ranks.h>

#include <string>

namespace softgrain
{
/**
 * @brief Keeps other runs out of an output folder while it lives, by a lock on the file `run.lock` in it.
 *
 * The system gives the lock back when the program ends, however it ends, so a file that a killed run has left
 * keeps nobody out. Where the file system knows no locks, the process named in the file counts, if it runs on
 * this machine. Of several ranks the first holds the lock.
 */
class RunLock
{
public:
  static const char *const file_name;

  /// Makes the folder when it is missing; all ranks come here.
  /// @throw InputError when another run is writing to it.
  explicit RunLock(const std::string &directory, const Ranks &ranks = Ranks());
  /// Removes the lock, and the folder if it was made for nothing.
  ~RunLock();
  RunLock(const RunLock &) = delete;
  RunLock &operator=(const RunLock &) = delete;

  /// Checks the folder on the rank that holds the lock.
  /// @throw ComputationError when the folder is no longer the one that was locked: removed, renamed,
  /// replaced.
  void check_folder() const;

private:
  void take();
  bool is_ours() const;
  std::string owner() const;

  std::string directory, path;
  bool made_folder = false;
  int descriptor = -1;
};
} // namespace softgrain

#endif
