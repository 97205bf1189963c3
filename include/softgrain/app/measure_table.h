// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_measure_table_h
#define softgrain_app_measure_table_h

#include <softgrain/analysis/measure.h>
#include <softgrain/output/history.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace softgrain
{
/// File of the measures in an output folder.
constexpr const char *measure_table_name = "measures.csv";

/// Columns of the table: time_s, step, and those of the measures.
template <int dim>
std::vector<std::string> measure_columns(const MeasureSetIn<dim> &measures);

/// A row of the table; what is not defined is not a number, and its field stays empty.
template <int dim>
HistoryRow measure_row(MeasureSeriesIn<dim> &measures, const Snapshot<dim> &snapshot);

/// Has @p measures remember the first and the last of the snapshots in @p directory up to @p time [s], if
/// there are any.
template <int dim>
void remember_snapshots(MeasureSeriesIn<dim> &measures, const std::string &directory, double time);

/**
 * @brief Takes measures from every snapshot of `snapshots.h5` in @p directory and writes them as a table.
 * @param output file name; empty: `measures.csv` in @p directory, whose old content is replaced
 * @param names of measures; empty: all
 * @param log told the name of the file
 * @throw InputError when there are no snapshots or a name is unknown, ComputationError when the disk refuses.
 */
void measure_snapshots(const std::string &directory,
                       const std::string &output,
                       const std::vector<std::string> &names,
                       std::ostream &log);
} // namespace softgrain

#endif
