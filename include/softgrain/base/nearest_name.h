// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_nearest_name_h
#define softgrain_base_nearest_name_h

#include <string>
#include <vector>

namespace softgrain
{
/// Number of insertions, deletions, replacements and swaps of neighbours that turn @p a into @p b, ignoring
/// case.
unsigned int edit_distance(const std::string &a, const std::string &b);

/// The name of @p names closest to @p word, or an empty string when none is near enough to be meant.
std::string nearest_name(const std::string &word, const std::vector<std::string> &names);

/// "a, b, c", or @p none when the list is empty.
std::string join(const std::vector<std::string> &words, const std::string &none = "(none)");
} // namespace softgrain

#endif
