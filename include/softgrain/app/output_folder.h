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

/// Makes the folder and removes the results of an earlier run in it, and nothing else.
void make_fresh_output_folder(const std::string &directory);
} // namespace softgrain

#endif
