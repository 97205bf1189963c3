// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_history_h
#define softgrain_output_history_h

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// One row of a table over time: names with their unit and values; the columns time_s, step come first.
using HistoryRow = std::vector<std::pair<std::string, double>>;

/// A row as text, as it stands in the file: names and values, separated by commas.
struct HistoryLine
{
  std::string names, values;

  bool empty() const { return names.empty(); }
};

/// A value that is not finite leaves its field empty.
HistoryLine line_of(const HistoryRow &row);

/**
 * @brief Writes `history.csv` or a table like it, row by row, so that a running computation can be watched.
 *
 * The first row ever written fixes the columns. A row is in the file whole or not at all, whatever the disk
 * does.
 */
class HistoryWriter
{
public:
  /// @param directory the output folder, which exists
  explicit HistoryWriter(const std::string &directory, const std::string &file_name = "history.csv");
  ~HistoryWriter();
  HistoryWriter(const HistoryWriter &) = delete;
  HistoryWriter &operator=(const HistoryWriter &) = delete;

  /**
   * @brief Goes on with the file that is there: rows after @p step are cut off.
   * @param columns those of the rows to come; empty: not known yet
   * @param own_row_stays whether a row of @p step itself stays; else the next row takes its place
   * @throw InputError when the file is no such table or has other columns.
   */
  void resume(std::uint64_t step, const std::vector<std::string> &columns = {}, bool own_row_stays = true);

  /// Whether nothing is written yet, and no file is continued.
  bool is_new() const { return header.empty(); }

  /// @throw InputError when the columns are not those of the file that is continued,
  /// ComputationError when the disk refuses.
  void write(const HistoryRow &row) { write_line(line_of(row)); }
  void write_line(const HistoryLine &line);

  /// Has the system bring all rows to the disk. @throw ComputationError when the disk refuses.
  void bring_to_disk() const;

private:
  void open(bool append);
  void check_columns(const std::string &names) const;
  void append(const std::string &text);

  const std::string path;
  int descriptor = -1; ///< of the open file; -1: none yet
  std::string header;
  std::uint64_t end_of_rows = 0; ///< of those that stay [bytes]
  bool cut_first = false;        ///< there is a row behind them that the next one replaces
};
} // namespace softgrain

#endif
