// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_series_h
#define softgrain_output_series_h

#include <softgrain/analysis/snapshot.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace softgrain
{
/// Six digits at least: `000042`.
std::string series_number(std::size_t number);

/// The shortest text that reads back as the same number.
std::string exact_text(double number);

/**
 * @brief Removes the files of a series, named PREFIX, digits, SUFFIX, that are not in @p kept, and unfinished
 * ones (`.part`). Other files of the folder are not touched.
 */
void remove_series_files(const std::string &folder,
                         const std::vector<std::string> &prefixes,
                         const std::string &suffix,
                         const std::set<std::string> &kept);

/// Removes a whole series: its index first, so that it never names a file that is gone, and the folder if it
/// is then empty.
void remove_series(const std::string &index,
                   const std::string &folder,
                   const std::vector<std::string> &prefixes,
                   const std::string &suffix);

/**
 * @brief The piece of an unbounded wall that is worth drawing: inside the other walls, and not far outside
 * the bodies. Two points; none when nothing of the wall is near the scene.
 */
std::vector<dealii::Point<2>> wall_segment(const Snapshot<2> &snapshot, unsigned int wall);
} // namespace softgrain

#endif
