// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_output_folder_h
#define softgrain_app_output_folder_h

#include <string>

namespace softgrain
{
/**
 * @brief Looks whether results can be written to @p directory, without touching anything.
 * @throw InputError when the place cannot be written or holds files that no run of ours has left.
 */
void check_output_folder(const std::string &directory);

/**
 * @brief Looks whether a new run may replace what is in @p directory.
 * @param overwrite whether the user gives up the run that is there
 * @throw InputError when a run is there, ended or not, or a file that is not ours and bears the name of a
 * checkpoint
 */
void check_may_begin_anew(const std::string &directory, bool overwrite);

/// @throw InputError when a run that goes on from @p checkpoint would mix its results with those of another
/// run.
void check_may_go_on(const std::string &directory, const std::string &checkpoint);

/**
 * @brief Whether a run with these parameters has begun in @p directory, and came to no end and to no
 * checkpoint: all that is lost by its beginning again is time.
 */
bool has_begun_without_checkpoint(const std::string &directory, const std::string &effective_parameters);

/// Removes the results of an earlier run and the pictures and pages that were drawn of them under the names
/// that the tools give by themselves, and nothing else.
void remove_old_results(const std::string &directory);

/// Removes the files of a run that were being written when it was killed.
void remove_unfinished_files(const std::string &directory);
} // namespace softgrain

#endif
