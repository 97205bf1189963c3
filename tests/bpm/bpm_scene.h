// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_bpm_bpm_scene_h
#define softgrain_tests_bpm_bpm_scene_h

// Tests of the bonded-particle model run small scenes, made by assignments as on the command line.
#include <softgrain/app/input.h>
#include <softgrain/bpm/bpm_model.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace softgrain
{
using Changes = std::vector<std::string>;

/// The model of a parameter file given as text, changed by "Section/Key=value".
inline std::unique_ptr<bpm::BpmModel> bpm_scene(const std::string &text, Changes changes = {})
{
  std::ofstream("scene.prm") << "set Model = bpm\n" << text;
  changes.insert(changes.begin(), "Output directory=results");
  Input input("scene.prm", changes);
  return std::unique_ptr<bpm::BpmModel>(dynamic_cast<bpm::BpmModel *>(input.create_model().release()));
}

/// Material, one grain of about 70 primaries in units near 1: radius 10, primaries of 1.6-2.6, F0 = 1,
/// density 1.
inline std::string grain_scene(const std::string &more = "")
{
  return R"(
subsection Materials
  set Names = m
  subsection m
    set Law = power_law
    set Density = 1
    subsection Power law
      set Force at contact = 1
    end
  end
end
subsection Primaries
  set Smallest diameter = 1.6
  set Largest diameter = 2.6
end
subsection Stop
  set End time = 1000
end
)" + more;
}

/// A section `Bodies` with disks of these centres, radius and velocities.
struct Disk
{
  std::string center, velocity;
};
inline std::string disks(const std::vector<Disk> &all, const std::string &radius)
{
  std::ostringstream text;
  text << "subsection Bodies\n  set Names = ";
  for (std::size_t i = 0; i < all.size(); ++i)
    text << (i > 0 ? ", " : "") << "d" << i;
  for (std::size_t i = 0; i < all.size(); ++i)
    text << "\n  subsection d" << i << "\n    set Center = " << all[i].center
         << "\n    set Radius = " << radius << "\n    set Velocity = " << all[i].velocity << "\n  end";
  text << "\nend\n";
  return text.str();
}

/// A figure that only has to be small: its limit when it is below, itself when it is not.
inline std::string below(const double limit, const double value)
{
  std::ostringstream text;
  if (std::abs(value) < limit)
    text << "below " << limit;
  else
    text << value;
  return text.str();
}

/// What energy is missing or too much now, over the largest of the energies.
inline double energy_error(const Energies &start, const Energies &now)
{
  const double scale = std::max({start.kinetic, now.kinetic, std::abs(now.elastic), now.dissipated});
  return (now.kinetic + now.elastic + now.dissipated - now.external_work - start.kinetic - start.elastic) /
         scale;
}
} // namespace softgrain

#endif
