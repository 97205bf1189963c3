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
/// One row of a table over time: names with their unit and values; the columns time_s, step come first.
using HistoryRow = std::vector<std::pair<std::string, double>>;

/**
 * @brief Writes `history.csv` or a table like it, row by row, so that a running computation can be watched.
 *
 * The first row ever written fixes the columns. A value that is not finite leaves its field empty.
 */
class HistoryWriter
{
public:
  /// @param directory the output folder, which exists
  explicit HistoryWriter(const std::string &directory, const std::string &file_name = "history.csv");

  /**
   * @brief Goes on with the file that is there: rows after @p step are cut off.
   * @param columns those of the rows to come; empty: not known yet
   * @throw InputError when the file is no such table or has other columns.
   */
  void resume(std::uint64_t step, const std::vector<std::string> &columns = {});

  /// Nothing is written yet, and no file is continued.
  bool is_new() const { return header.empty(); }

  /// @throw InputError when the columns are not those of the file that is continued,
  /// ComputationError when the disk refuses.
  void write(const HistoryRow &row);

private:
  void open(bool append);
  void check_columns(const std::string &names) const;

  const std::string path;
  std::ofstream file;
  std::string header;
};
} // namespace softgrain

#endif
