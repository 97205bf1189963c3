// SPDX-License-Identifier: LGPL-2.1-or-later
// fields.pvd and snapshots.h5 while a run goes on, is continued from an earlier time, and is started anew.
#include "synthetic.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/series.h>
#include <softgrain/output/snapshot_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace softgrain;

namespace
{
void show(const std::string &title)
{
  std::cout << "== " << title << '\n';
  std::ifstream index("run/fields.pvd");
  for (std::string line; std::getline(index, line);)
    std::cout << line << '\n';
  std::vector<std::string> files;
  for (const char *folder : {"run", "run/fields", "run/snapshots"})
    for (const auto &entry : std::filesystem::directory_iterator(folder))
      if (entry.is_regular_file())
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const std::string &file : files)
    std::cout << file << '\n';
  for (const double time : snapshot_times("run/snapshots.h5"))
    std::cout << "snapshot at " << time << '\n';
}

template <typename Writer, typename Snapshots>
void write(Writer &pictures, Snapshots &snapshots, const double time)
{
  const Snapshot<2> snapshot = synthetic::squeezed_disk(time, 10 * time, 8);
  pictures.write(snapshot);
  snapshots.append(snapshot);
}
} // namespace

int main()
{
  FieldOptions options;
  options.contacts = options.walls = false;
  {
    FieldWriter pictures("run", options);
    SnapshotFile snapshots("run");
    for (const double time : {0., 0.001, 0.1 * 0.02 + 1e-18, 0.003})
      write(pictures, snapshots, time);
  }
  std::ofstream("run/fields/outlines-000009.vtu.part") << "left by a crash";
  std::ofstream("run/fields/points-of-mine.vtu") << "not ours";
  show("four frames");
  {
    FieldWriter pictures("run", options);
    SnapshotFile snapshots("run");
    pictures.resume(0.0015);
    snapshots.resume(0.0015);
    write(pictures, snapshots, 0.0018);
  }
  show("continued from 0.0015");
  std::cout << "step of the last: " << read_snapshot("run/snapshots.h5", 2).step << '\n';
  {
    FieldWriter pictures("run", options);
    SnapshotFile snapshots("run");
    write(pictures, snapshots, 0);
  }
  show("started anew");

  std::ofstream("run/fields.pvd") << "<VTKFile><Collect";
  try
  {
    FieldWriter("run").resume(1);
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
  for (const std::size_t index : {1, 0})
    try
    {
      std::filesystem::remove(index == 0 ? "run/snapshots/000000.h5" : "nothing");
      read_snapshot("run/snapshots.h5", index);
    }
    catch (const InputError &error)
    {
      // What follows is HDF5's reason, in words of its release.
      const std::string message = error.what(), said = "there is no such attribute: ";
      const auto reason = message.find(said);
      std::cout << (reason == std::string::npos ? message : message.substr(0, reason + said.size() - 2))
                << (reason != std::string::npos && message.size() > reason + said.size() ? ", with a reason"
                                                                                         : "")
                << '\n';
    }

  // Walls are drawn up to the walls they meet.
  const Snapshot<2> box = synthetic::packing(2, 2);
  for (unsigned int wall = 0; wall < 4; ++wall)
    std::cout << box.walls[wall].name << ": " << wall_segment(box, wall)[0] << " to "
              << wall_segment(box, wall)[1] << '\n';
}
