// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/measure_table.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/snapshot_file.h>
#include <softgrain/parameters/parameter_file.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <limits>
#include <ostream>

namespace softgrain
{
namespace fs = std::filesystem;

template <int dim>
std::vector<std::string> measure_columns(const MeasureSetIn<dim> &measures)
{
  std::vector<std::string> names = {"time_s", "step"};
  for (const std::string &column : measures.columns())
    names.push_back(column);
  return names;
}

template <int dim>
HistoryRow measure_row(MeasureSeriesIn<dim> &measures, const Snapshot<dim> &snapshot)
{
  HistoryRow row = {{"time_s", snapshot.time}, {"step", static_cast<double>(snapshot.step)}};
  for (const auto &[name, value] : measures.evaluate(snapshot))
    row.emplace_back(name, value.value_or(std::numeric_limits<double>::quiet_NaN()));
  return row;
}

template <int dim>
void remember_snapshots(MeasureSeriesIn<dim> &measures, const std::string &directory, const double time)
{
  const std::string path = (fs::path(directory) / "snapshots.h5").string();
  if (!fs::exists(path))
    return;
  std::size_t n = 0;
  for (const double taken : snapshot_times(path))
    n += taken <= time;
  if (n > 0)
    measures.remember(read_snapshot<dim>(path, 0));
  if (n > 1)
    measures.remember(read_snapshot<dim>(path, n - 1));
}

namespace
{
/// Friction between bodies of the run in @p directory, as uniform_friction(); nothing when its parameters are
/// not there.
/// @throw InputError when they do not say it in a number
std::optional<double> friction_of(const std::string &directory)
{
  const fs::path file = fs::path(directory) / "parameters.prm";
  if (!fs::exists(file))
    return std::nullopt;
  const ParameterFile parameters(file.string());
  // Which friction a contact has is not in the snapshots.
  if (!parameters.value({"Contact"}, "Friction of pairs", "").empty() ||
      parameters.value({"Contact"}, "Law", "coulomb") != "coulomb")
    return std::nullopt;
  const std::string friction = parameters.value({"Contact"}, "Friction", "0");
  if (!dealii::Patterns::Double(0).match(friction))
    throw InputError(parameters.where({"Contact"}, "Friction") + ": 'Contact/Friction' = '" + friction +
                     "' is not allowed: it must be a number of at least 0");
  return dealii::Utilities::string_to_double(friction);
}

/// @param names of measures; empty: all
template <int dim>
void write_table(const fs::path &snapshots,
                 const std::size_t n,
                 const std::vector<std::string> &names,
                 const std::optional<double> friction,
                 const fs::path &path)
{
  MeasureSeriesIn<dim> measures(names.empty() ? std::vector<std::string>{"all"} : names, friction);
  HistoryWriter table(path.parent_path().string(), path.filename().string());
  for (std::size_t i = 0; i < n; ++i)
    table.write(measure_row(measures, read_snapshot<dim>(snapshots.string(), i)));
}
} // namespace

void measure_snapshots(const std::string &directory,
                       const std::string &output,
                       const std::vector<std::string> &names,
                       std::ostream &log)
{
  const std::optional<double> friction = friction_of(directory);
  if (!fs::is_directory(directory))
    throw InputError("there is no folder " + directory);
  const fs::path snapshots = fs::path(directory) / "snapshots.h5";
  if (!fs::exists(snapshots))
    throw InputError(directory + " has no snapshots.h5: set 'Output/Snapshots every' when it is run");
  const std::size_t n = snapshot_times(snapshots.string()).size();
  if (n == 0)
    throw InputError(snapshots.string() + " holds no snapshot yet");
  const fs::path path = output.empty() ? fs::path(directory) / measure_table_name : fs::path(output);
  AtomicFile target(path.string());
  if (dimension_of_snapshots(snapshots.string()) == 3)
    write_table<3>(snapshots, n, names, friction, target.temporary_path());
  else
    write_table<2>(snapshots, n, names, friction, target.temporary_path());
  target.commit();
  log << path.string() << ": " << n << " rows\n";
}

template std::vector<std::string> measure_columns<2>(const MeasureSetIn<2> &);
template std::vector<std::string> measure_columns<3>(const MeasureSetIn<3> &);
template HistoryRow measure_row<2>(MeasureSeriesIn<2> &, const Snapshot<2> &);
template HistoryRow measure_row<3>(MeasureSeriesIn<3> &, const Snapshot<3> &);
template void remember_snapshots<2>(MeasureSeriesIn<2> &, const std::string &, double);
template void remember_snapshots<3>(MeasureSeriesIn<3> &, const std::string &, double);
} // namespace softgrain
