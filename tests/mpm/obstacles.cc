// SPDX-License-Identifier: LGPL-2.1-or-later
// Obstacles and soft disks: one that rests on two ends presses on them along its radii; one in a groove
// presses on both flanks alike; a plate that rises is the wall that rises so, with and without friction and
// inertia; a disk in an arc swings with the period of a pendulum, sliding or rolling; a small disk that
// touches the end of a plate which leans over it is at rest, for no part of it went through the plate; of a
// plate that turns energies balance, wherever the scene stands.
#include "gel.h"
#include "scene_of.h"

#include <softgrain/base/mpi_session.h>

#include <algorithm>
#include <iostream>
#include <sstream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;

const double pi = std::acos(-1.);

/// A soft disk of radius 5 mm about the origin, and @p more.
std::string disk_scene(const std::string &more)
{
  return R"(
subsection Mesh
  set Lower     = -16e-3, -16e-3
  set Upper     = 16e-3, 16e-3
  set Cell size = 1e-3
end
)" + gel("0.3", "1e6", "1000") +
         R"(subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 5e-3
  end
end
subsection Stop
  set End time = 10
end
)" + more;
}

const double weight = 1000. * 9.81 * pi * 25e-6;

void on_two_ends()
{
  const std::string ends = R"(
subsection Obstacles
  set Names = left, right
  subsection left
    set Points = -12e-3, -4.3301271e-3; -2.5e-3, -4.3301271e-3
  end
  subsection right
    set Points = 2.5e-3, -4.3301271e-3; 4e-3, -12e-3
  end
end
subsection Loads
  set Gravity = 0, -9.81
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 1
end
)";
  const auto model = scene_of_text(disk_scene(ends));
  run_until(*model, 1.);
  std::cout << "on two ends: forces over the weight";
  for (const ObstacleState<2> &one : model->obstacles())
    std::cout << ' ' << one.force / weight;
  std::cout << ", expected 0.288675 outwards and 0.5 downwards\n";
}

void in_a_groove()
{
  const std::string groove = R"(
subsection Walls
  set Names = top
  subsection top
    set Point    = 0, 5e-3
    set Velocity = 1e-3
  end
end
subsection Obstacles
  set Names = left, right
  subsection left
    set Points = -10e-3, 2.9289e-3; 0, -7.0711e-3
  end
  subsection right
    set Points = 0, -7.0711e-3; 10e-3, 2.9289e-3
  end
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 0.05
end
)";
  const auto model = scene_of_text(disk_scene(groove));
  run_until(*model, 0.5);
  const double force = model->walls()[0].normal_force;
  std::cout << "in a groove, pressed by a tenth of the radius: forces over that of the wall";
  for (const ObstacleState<2> &one : model->obstacles())
    std::cout << ' ' << one.force / force;
  std::cout << ", torque of both together over force times radius "
            << below(1e-3, (model->obstacles()[0].torque + model->obstacles()[1].torque) / (force * 5e-3))
            << '\n';
}

/// The force on the upper wall when a wall or a plate rises.
double under(const bool plate, const Changes &changes, const double end)
{
  const std::string scene = disk_scene(plate ? R"(
subsection Walls
  set Names = top
  subsection top
    set Point    = 0, 5.1e-3
    set Friction = 0.4
  end
end
subsection Obstacles
  set Names = plate
  subsection plate
    set Points       = -14e-3, -5.1e-3; 14e-3, -5.1e-3
    set Displacement = 0; 0.2*t
    set Friction     = 0.4
  end
end
)"
                                             : R"(
subsection Walls
  set Names = top, bottom
  subsection top
    set Point    = 0, 5.1e-3
    set Friction = 0.4
  end
  subsection bottom
    set Point    = 0, -5.1e-3
    set Velocity = 0.2
    set Friction = 0.4
  end
end
)");
  Changes all = {"Contact/Sub-grid compliance=false", "Bodies/disk/Angular velocity=20"};
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = scene_of_text(scene, all);
  EnergyWatch energy(*model);
  double impulse = 0.;
  run_until(*model, end,
            [&](const StepReport &report)
            {
              energy.look(*model);
              if (plate)
                impulse -= report.dt * (model->obstacles()[0].force[1] + model->walls()[0].normal_force);
            });
  const double force = model->walls()[0].normal_force;
  if (plate)
  {
    std::cout << "  momentum error " << below(1e-11, model->momentum_error()) << ", energy error "
              << below(0.03, energy.error());
    // In motion the disk swings between both: the forces of one moment are any ratio, their impulse is not.
    const BodyState<2> disk = model->snapshot().bodies[0];
    if (model->energies().kinetic > 0.)
      std::cout << ", impulse of both over momentum " << impulse / (disk.mass * disk.velocity[1]) << '\n';
    else
      std::cout << ", force below over force above " << -model->obstacles()[0].force[1] / force << '\n';
  }
  return force;
}

void plate_and_wall(const std::string &what, const Changes &changes, const double end)
{
  const double plate = under(true, changes, end), wall = under(false, changes, end);
  std::cout << what << ": plate over wall off by " << below(1e-6, plate / wall - 1.) << '\n';
}

/// Period in an arc of radius 15 mm from an angle of 0.15, over that of a pendulum of 10 mm.
double period(const double friction)
{
  const std::string arc = R"(
subsection Obstacles
  set Names = bowl
  subsection bowl
    set Shape  = arc
    set Center = 0, 10e-3
    set Radius = 15e-3
    set From   = 180
    set To     = 360
  end
end
subsection Loads
  set Gravity = 0, -9.81
end
subsection Time
  set Time step = 1e-3
  set Theta     = 0.5
end
)";
  const double angle = 0.15;
  std::ostringstream center, strength;
  center << "Bodies/disk/Center=" << 10e-3 * std::sin(angle) << "," << 10e-3 * (1. - std::cos(angle)) + 1e-7;
  strength << "Obstacles/bowl/Friction=" << friction;
  const auto model = scene_of_text(disk_scene(arc), {center.str(), strength.str()});
  std::vector<double> crossings;
  double before = 1., last = 0.;
  while (crossings.size() < 3 && model->time() < 1.)
  {
    model->advance(1.);
    const double now = model->snapshot().bodies[0].center[0];
    if (before * now <= 0.)
      crossings.push_back(model->time() - (model->time() - last) * now / (now - before));
    before = now;
    last = model->time();
  }
  return crossings.size() < 3 ? 0.
                              : (crossings[2] - crossings[0]) /
                                    (2. * pi * std::sqrt(10e-3 / 9.81) * (1. + angle * angle / 16.));
}

void at_the_end_of_a_plate()
{
  double energy = 0.;
  for (const double degrees : {-24., -20., -16., 16., 18., 20., 22., 24.})
    for (const double radius : {1.3e-3, 1.6e-3, 1.9e-3})
    {
      const double lean = degrees * pi / 180., begin = 1.0001 * radius;
      std::ostringstream points;
      points << "0, " << begin << "; " << 5e-3 * std::sin(lean) << ", " << begin + 5e-3 * std::cos(lean);
      const auto model = scene_of_text(
          disk_scene("subsection Obstacles\n set Names = plate\n subsection plate\n set Points = " +
                     points.str() + "\n end\nend\n"),
          {"Bodies/disk/Radius=" + std::to_string(radius), "Time/Time step=1e-4"});
      run_until(*model, 3e-4);
      energy = std::max(energy, model->energies().kinetic + model->energies().elastic);
    }
  std::cout << "at the end of a plate: energy " << energy << '\n';
}

/// A plate under a disk turns about a pivot to the right of it and throws it up.
void turns(const double friction)
{
  for (const double x : {0., 64e-3})
  {
    std::ostringstream points, pivot, center, lower, upper, strength;
    points << "Obstacles/plate/Points=" << x - 12e-3 << ", -5.1e-3; " << x + 12e-3 << ", -5.1e-3";
    pivot << "Obstacles/plate/Pivot=" << x + 12e-3 << ", -5.1e-3";
    center << "Bodies/disk/Center=" << x << ", 0";
    lower << "Mesh/Lower=" << x - 16e-3 << ", -16e-3";
    upper << "Mesh/Upper=" << x + 16e-3 << ", 16e-3";
    strength << "Obstacles/plate/Friction=" << friction;
    const auto model =
        scene_of_text(disk_scene("subsection Obstacles\n set Names = plate\n subsection plate\n set Angle = "
                                 "-1000*t\n set Points = 0, 0; 1, 0\n end\nend\n"),
                      {points.str(), pivot.str(), center.str(), lower.str(), upper.str(), strength.str(),
                       "Contact/Sub-grid compliance=false", "Time/Time step=1e-4"});
    EnergyWatch energy(*model);
    run_until(*model, 4e-3, [&](const StepReport &) { energy.look(*model); });
    std::cout << "plate that turns, friction " << friction << ", the scene at " << x << ": "
              << (model->snapshot().bodies[0].velocity[1] > 0.2 ? "thrown up" : "NOT thrown up")
              << ", energy error " << below(1e-3, energy.error()) << '\n';
  }
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  on_two_ends();
  in_a_groove();
  at_the_end_of_a_plate();
  turns(0.);
  turns(0.4);
  plate_and_wall("in motion", {"Time/Time step=1e-4"}, 4e-3);
  plate_and_wall("in balance",
                 {"Time/Scheme=quasi_static", "Time/Time step=5e-4", "Bodies/disk/Angular velocity=0"}, 4e-3);
  const double sliding = period(0.), rolling = period(1.);
  std::cout << "period over that of a pendulum, sliding " << sliding << ", rolling " << rolling
            << ", expected 1 and " << std::sqrt(1.5) << '\n';
}
