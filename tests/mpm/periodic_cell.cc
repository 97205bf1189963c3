// SPDX-License-Identifier: LGPL-2.1-or-later
// A cell that repeats. Two disks that meet across its edges are two disks in its middle; momentum is kept.
// Thirty grains pressed by the sides: the stress is the pressure, the same from the contacts and from the
// material points, and its work is the energy of the grains. Sheared by a lattice that slides, their stress
// is symmetric; free to slide under a shear stress, it has that.
#include "gel.h"
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;

const std::string two_disks = R"(
subsection Mesh
  set Lower     = -6e-3, -6e-3
  set Upper     = 30e-3, 30e-3
  set Cell size = 1e-3
end
)" + gel("0.45") + R"(subsection Bodies
  set Names = one, two
  subsection one
    set Radius = 4e-3
    set Velocity = 2; 0
  end
  subsection two
    set Radius = 4e-3
    set Velocity = -1; 0.3
  end
end
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Type = periodic
  end
  subsection top
    set Type = periodic
    set Point = 0, 20e-3
  end
  subsection left
    set Type = periodic
  end
  subsection right
    set Type = periodic
    set Point = 20e-3, 0
  end
end
subsection Stop
  set End time = 1
end
)";

/// How far two runs of the same bodies are apart, over the largest velocity.
double difference(const mpm::MpmModel &a, const mpm::MpmModel &b)
{
  double worst = 0., largest = 0.;
  for (unsigned int i = 0; i < a.bodies().size(); ++i)
  {
    worst = std::max(worst,
                     (a.bodies()[i].nodes.velocity - b.bodies()[i].nodes.velocity).lpNorm<Eigen::Infinity>());
    largest = std::max(largest, a.bodies()[i].nodes.velocity.lpNorm<Eigen::Infinity>());
  }
  return worst / largest;
}

void across_edges(const std::string &what, const Changes &changes)
{
  const auto place = [&](const std::string &one, const std::string &two)
  {
    Changes all = {"Bodies/one/Center=" + one, "Bodies/two/Center=" + two};
    all.insert(all.end(), changes.begin(), changes.end());
    return scene_of_text(two_disks, all);
  };
  const auto middle = place("6e-3, 10e-3", "14.2e-3, 11e-3");
  // A vector of the lattice lies between the second disk and what the first one meets.
  const auto edge = place("16e-3, 20e-3", "4.2e-3, 1e-3"), corner = place("16e-3, 20e-3", "24.2e-3, 21e-3");
  EnergyWatch energy(*edge);
  double apart = 0.;
  std::size_t contacts = 0;
  for (unsigned int i = 0; i < 25; ++i)
  {
    const StepReport report = middle->advance(1.);
    contacts = std::max<std::size_t>(contacts, report.n_contacts);
    for (const auto &other : {&edge, &corner})
    {
      (*other)->advance(1.);
      apart = std::max(apart, difference(*middle, **other));
    }
    energy.look(*edge);
  }
  std::cout << what << ": contact " << (contacts > 0 ? "yes" : "no") << ", middle and edges differ by "
            << below(1e-9, apart) << ", momentum error " << below(1e-12, edge->momentum_error())
            << ", energy from nowhere " << below(0.01, energy.gained()) << std::endl;
}

/// Stress on the sides, xx and yy, compression positive, and both shear stresses [Pa].
struct SideStress
{
  explicit SideStress(const mpm::MpmModel &model)
  {
    const auto walls = model.walls(); // bottom, top, left, right
    width = walls[3].position - walls[2].position;
    height = walls[1].position - walls[0].position;
    xx = walls[3].normal_force / height;
    yy = walls[1].normal_force / width;
    xy = -walls[1].tangential_force / width;
    yx = walls[3].tangential_force / height;
  }
  double width, height, xx, yy, xy, yx;
};

/// Mean of the pressure in the material points over the cell [Pa].
double pressure_of_points(const mpm::MpmModel &model)
{
  const Snapshot<2> snapshot = model.snapshot();
  double sum = 0.;
  for (std::size_t p = 0; p < snapshot.points.size.size(); ++p)
    sum -= 0.5 * trace(snapshot.points.stress[p]) * snapshot.points.size[p];
  const SideStress stress(model);
  return sum / (stress.width * stress.height);
}

void compact(const std::string &what, const Changes &changes)
{
  Changes all = {"Stop/End time=1",
                 "Mesh/Cell size=4e-4",
                 "Contact/Friction=0",
                 "Time/Time step=3.2e-5",
                 "Walls/top/Drive=pressure",
                 "Walls/top/Pressure=2e9*t",
                 "Walls/right/Drive=pressure",
                 "Walls/right/Pressure=2e9*t"};
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = shipped_scene("gallery/simple_shear_periodic.prm", all);
  double worst = 0., points = 0.;
  Energies loose;
  for (unsigned int i = 1; i <= 3; ++i)
  {
    model->advance(1.);
    const SideStress stress(*model);
    worst = std::max({worst, std::abs(stress.xx / (6.4e4 * i) - 1.), std::abs(stress.yy / (6.4e4 * i) - 1.)});
    points = std::max(points, std::abs(pressure_of_points(*model) / (6.4e4 * i) - 1.));
    if (i == 1)
      loose = model->energies();
  }
  const Energies dense = model->energies();
  const double work = dense.external_work - loose.external_work, energy = dense.elastic - loose.elastic,
               lost = dense.dissipated - loose.dissipated;
  std::cout << what << ": stresses off by " << below(5e-4, worst) << ", of points by " << below(0.01, points)
            << ", packing fraction "
            << model->solid_area() / (SideStress(*model).width * SideStress(*model).height)
            << ", coordination " << model->coordination() << ", work over energy " << work / (energy + lost)
            << std::endl;
}

/// Thirty grains under 1e5 Pa, whose lattice slides by what @p drive says from 6e-5 s on.
std::unique_ptr<mpm::MpmModel> sheared(const Changes &changes, const std::string &drive)
{
  Changes all = {"Mesh/Cell size=4e-4"};
  all.insert(all.end(), changes.begin(), changes.end());
  all.insert(all.end(), {"Stop/End time=1", "Walls/top/Drive=pressure", "Walls/top/Pressure=1e5",
                         "Walls/right/Drive=pressure", "Walls/right/Pressure=1e5", "Walls/top/" + drive});
  return shipped_scene("gallery/simple_shear_periodic.prm", all);
}

void shear(const std::string &what, const Changes &changes)
{
  const auto model = sheared(changes, "Tangential velocity=t < 6e-5 ? 0 : -1.5");
  double asymmetry = 0., largest = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    model->advance(1.);
    const SideStress stress(*model);
    asymmetry = std::max(asymmetry, std::abs(stress.xy - stress.yx) / stress.yy);
    largest = std::max(largest, std::abs(stress.xy) / stress.yy);
  }
  std::cout << what << ": sheared by " << model->walls()[1].offset / SideStress(*model).height
            << ", largest shear stress " << largest << ", asymmetry " << below(0.01, asymmetry) << std::endl;
}

/// The lattice is free to slide, under a fifth of the pressure.
void shear_stress(const std::string &what, const Changes &changes)
{
  const auto model = sheared(changes, "Shear stress=t < 6e-5 ? 0 : 2e4");
  double asymmetry = 0., off = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    model->advance(1.);
    const SideStress stress(*model);
    asymmetry = std::max(asymmetry, std::abs(stress.xy - stress.yx) / stress.yy);
    if (i > 0)
      off = std::max(off, std::abs(std::abs(stress.xy) / 2e4 - 1.));
  }
  std::cout << what << ": stress along top off by " << below(5e-3, off) << ", asymmetry "
            << below(0.01, asymmetry) << ", slid " << (model->walls()[1].offset < 0. ? "along" : "AGAINST")
            << " it" << std::endl;
}
} // namespace

int main()
{
  across_edges("collision", {});
  across_edges("with friction", {"Contact/Friction=0.5"});
  compact("compaction", {});
  shear("simple shear", {"Contact/Friction=0"});
  shear("with friction", {"Contact/Friction=0.5"});
  shear_stress("under a shear stress", {"Contact/Friction=0.5"});
}
