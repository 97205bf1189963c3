// SPDX-License-Identifier: LGPL-2.1-or-later
// Writes two output folders that look like those of runs, disk/ and packing/; the tests of the Python tools
// draw them. Argument: number of disks across and up in the packing.
#include "synthetic.h"

#include <softgrain/output/field_writer.h>
#include <softgrain/output/snapshot_file.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace
{
void write_parameters(const std::string &directory)
{
  std::ofstream(directory + "/parameters.prm") << "set Model = mpm\n"
                                                  "subsection Materials\n"
                                                  "  subsection rubber\n"
                                                  "    set Density = 990\n"
                                                  "    set Law     = neo_hookean\n"
                                                  "    subsection Neo-Hookean\n"
                                                  "      set Poisson's ratio = 0.45\n"
                                                  "      set Young's modulus = 10e6 # Pa\n"
                                                  "    end\n"
                                                  "  end\n"
                                                  "end\n"
                                                  "subsection Bodies\n"
                                                  "  set Names = disk\n"
                                                  "  subsection disk\n"
                                                  "    set Shape  = disk\n"
                                                  "    set Radius = 5e-3\n"
                                                  "  end\n"
                                                  "end\n"
                                                  "subsection Walls\n"
                                                  "  set Names = bottom, top\n"
                                                  "end\n";
}
} // namespace

int main(const int argc, const char **argv)
{
  using namespace softgrain;
  const unsigned int n = argc > 1 ? std::stoi(argv[1]) : 6;
  std::filesystem::create_directories("disk");
  FieldWriter pictures("disk");
  SnapshotFile snapshots("disk");
  std::ofstream history("disk/history.csv");
  history << "time_s,step,dt_s,bottom_position_m,bottom_force_N_per_m,top_position_m,top_force_N_per_m,"
             "axial_strain,packing_fraction,kinetic_energy_J_per_m\n";
  for (unsigned int i = 0; i <= 60; ++i)
  {
    const double time = 2.5e-4 * i, squeeze = 0.2 * time / 10e-3;
    const Snapshot<2> snapshot = synthetic::squeezed_disk(time, squeeze, 35);
    history.precision(12);
    history << time << ',' << snapshot.step << ",1e-7,0," << snapshot.walls[0].normal_force << ','
            << snapshot.walls[1].position << ',' << snapshot.walls[1].normal_force << ','
            << -std::log(1 - squeeze) << ",," << snapshot.energies.kinetic << '\n';
    if (i % 20 == 0)
    {
      pictures.write(synthetic::squeezed_disk(time, squeeze));
      snapshots.append(snapshot);
    }
  }
  write_parameters("disk");
  std::cout << "disk: " << pictures.n_frames() << " frames, " << snapshots.n_snapshots() << " snapshots\n";

  const Snapshot<2> packing = synthetic::packing(n, n);
  FieldWriter packing_pictures("packing");
  packing_pictures.write(packing);
  std::cout << "packing: " << packing.bodies.size() << " bodies, " << packing.contacts.size() << " contacts, "
            << packing.points.position.size() << " points\n";
}
