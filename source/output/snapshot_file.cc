// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/hdf5_reader.h>
#include <softgrain/output/hdf5_writer.h>
#include <softgrain/output/series.h>
#include <softgrain/output/snapshot_file.h>
#include <softgrain/output/snapshot_layout.h>
#include <softgrain/output/units.h>

#include <filesystem>
#include <set>

namespace softgrain
{
namespace
{
const std::string index_format = "softgrain snapshots 1";

std::string part_name(const std::size_t number)
{
  return "snapshots/" + series_number(number) + ".h5";
}
std::string group_name(const std::size_t number)
{
  return "steps/" + series_number(number);
}

void check_index(const Hdf5Reader &file, const std::string &path)
{
  if (!file.has_attribute("/", "format") || file.read_text_attribute("/", "format") != index_format)
    throw InputError(path + " is not an index of snapshots of this version ('" + index_format + "')");
}
} // namespace

SnapshotFile::SnapshotFile(const std::string &directory, const SnapshotOptions &options)
    : directory(directory), options(options)
{
}

void SnapshotFile::resume(const double time)
{
  entries.clear();
  const std::string path = directory + "/snapshots.h5";
  if (!std::filesystem::exists(path))
    return;
  const Hdf5Reader file(path);
  check_index(file, path);
  const std::vector<double> times = file.read_doubles("time_s");
  const std::vector<std::uint64_t> steps = file.read_integers("step");
  for (std::size_t i = 0; i < times.size() && i < steps.size() && times[i] <= time; ++i)
    entries.push_back({times[i], steps[i]});
}

template <int dim>
void SnapshotFile::append(const Snapshot<dim> &snapshot)
{
  while (!entries.empty() && entries.back().time >= snapshot.time)
    entries.pop_back();
  if (!stale_files_removed)
  {
    // The index first, so that it never points to a file that is gone.
    write_index();
    remove_stale_files();
    stale_files_removed = true;
  }
  AtomicFile target(directory + "/" + part_name(entries.size()));
  Hdf5Writer file(target.temporary_path(), options.compression_level);
  write_snapshot(file, snapshot, options.points);
  file.close();
  target.commit(late);
  entries.push_back({snapshot.time, snapshot.step});
  write_index();
}

void SnapshotFile::write_index()
{
  AtomicFile target(directory + "/snapshots.h5");
  Hdf5Writer file(target.temporary_path());
  std::vector<double> times;
  std::vector<std::uint64_t> steps;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    times.push_back(entries[i].time);
    steps.push_back(entries[i].step);
    file.link(group_name(i), part_name(i), "/");
  }
  file.write_attribute("/", "format", index_format);
  file.write("time_s", times);
  file.write("step", steps);
  write_units(file);
  file.close();
  // A failure of power may take the newest snapshots, but never the index of all.
  target.sync();
  target.commit(late);
}

void SnapshotFile::remove_stale_files() const
{
  std::set<std::string> kept;
  for (std::size_t i = 0; i < entries.size(); ++i)
    kept.insert(std::filesystem::path(part_name(i)).filename());
  remove_series_files(directory + "/snapshots", {""}, ".h5", kept);
}

void remove_snapshots(const std::string &directory)
{
  remove_series(directory + "/snapshots.h5", directory + "/snapshots", {""}, ".h5");
}

std::vector<double> snapshot_times(const std::string &path)
{
  const Hdf5Reader file(path);
  check_index(file, path);
  return file.read_doubles("time_s");
}

template <int dim>
Snapshot<dim> read_snapshot(const std::string &path, const std::size_t index)
{
  const Hdf5Reader file(path);
  check_index(file, path);
  const std::string group = group_name(index) + "/";
  if (!file.contains(group_name(index)))
    throw InputError(path + " has no snapshot number " + std::to_string(index) + ", it has " +
                     std::to_string(file.read_doubles("time_s").size()));
  return read_snapshot_group<dim>(file, group);
}

unsigned int dimension_of_snapshots(const std::string &path)
{
  const Hdf5Reader file(path);
  check_index(file, path);
  return file.contains(group_name(0)) ? dimension_of_snapshot(file, group_name(0) + "/") : 2;
}

template void SnapshotFile::append<2>(const Snapshot<2> &);
template void SnapshotFile::append<3>(const Snapshot<3> &);
template Snapshot<2> read_snapshot<2>(const std::string &, std::size_t);
template Snapshot<3> read_snapshot<3>(const std::string &, std::size_t);
} // namespace softgrain
