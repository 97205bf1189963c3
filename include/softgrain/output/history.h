// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_history_h
#define softgrain_output_history_h

#include <cstdint>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// One row of `history.csv`: names with their unit and values; the columns time_s, step, dt_s come first.
using HistoryRow = std::vector<std::pair<std::string, double>>;

/**
 * @brief Writes `history.csv`, row by row, so that a running computation can be watched.
 *
 * The first row ever written fixes the columns. A value that is not finite leaves its field empty.
 */
class HistoryWriter
{
public:
  /// @param directory the output folder, which exists
  explicit HistoryWriter(const std::string &directory);

  /**
   * @brief Goes on with the file that is there: rows after @p step are cut off.
   * @throw InputError when the file is not a history.
   */
  void resume(std::uint64_t step);

  /// @throw InputError when the columns are not those of the file that is continued,
  /// ComputationError when the disk refuses.
  void write(const HistoryRow &row);

private:
  void open(bool append);

  const std::string path;
  std::ofstream file;
  std::string header;
};
} // namespace softgrain

#endif
