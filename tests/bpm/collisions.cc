// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that meet: single primaries bounce with their restitution, aggregates conserve momentum and the
// books of energy balance; a wall with mass takes its share; a fixed body keeps its velocity.
#include <deal.II/base/numbers.h>

#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;

namespace
{
void bounce(const std::string &restitution)
{
  // One primary of unit diameter per body, without attraction.
  const auto model = bpm_scene(grain_scene(disks({{"-2, 0", "1; 0"}, {"2, 0", "-0.5; 0"}}, "1")),
                               {"Primaries/Smallest diameter=1", "Primaries/Largest diameter=1",
                                "Primaries/Number per body=1", "Materials/m/Power law/Force at contact=0",
                                "Time/Time step=0.013", "Contact/Restitution=" + restitution});
  while (model->time() < 4.)
    model->advance(4. - model->time());
  const Snapshot<2> end = model->snapshot();
  std::cout << "restitution " << restitution << ": velocities " << end.bodies[0].velocity[0] << ' '
            << end.bodies[1].velocity[0] << ", momentum " << below(1e-14, model->momentum_error())
            << ", energy "
            << below(1e-13, energy_error({1.25 * 0.25 * 0.5 * dealii::numbers::PI, 0., 0., 0.}, end.energies))
            << '\n';
}

void fast()
{
  // A step closes 0.09 diameters, far more than the range of a contact; the last gap before the impact is
  // 0.03.
  const auto model = bpm_scene(grain_scene(disks({{"-2, 0", "1; 0"}, {"2, 0", "-0.5; 0"}}, "1")),
                               {"Primaries/Smallest diameter=1", "Primaries/Largest diameter=1",
                                "Primaries/Number per body=1", "Materials/m/Power law/Force at contact=0",
                                "Time/Time step=0.06"});
  double penetration = 0.;
  unsigned int repeated = 0;
  while (model->time() < 4.)
  {
    const StepReport step = model->advance(4. - model->time());
    penetration = std::max(penetration, step.max_penetration);
    repeated += step.attempts - 1;
  }
  std::cout << "fast: penetration " << below(1e-12, penetration) << ", steps repeated " << repeated << '\n';
}

void aggregates(const std::string &what, const std::string &second, const Changes &changes)
{
  const auto model =
      bpm_scene(grain_scene(disks({{"-10.6, 0", "0.3; 0"}, {second, "-0.3; 0"}}, "10")), changes);
  const Snapshot<2> start = model->snapshot();
  double penetration = 0.;
  while (model->time() < 60.)
    penetration = std::max(penetration, model->advance(60. - model->time()).max_penetration);
  const Snapshot<2> end = model->snapshot();
  const auto turning = [](const Snapshot<2> &now)
  {
    double sum = 0.;
    for (const BodyState<2> &body : now.bodies)
      sum += body.angular_momentum +
             body.mass * (body.center[0] * body.velocity[1] - body.center[1] * body.velocity[0]);
    return sum;
  };
  std::cout << what << ": pieces " << end.bodies[0].outline.size() + end.bodies[1].outline.size()
            << ", dissipated " << (end.energies.dissipated > 0.5 * start.energies.kinetic ? "most" : "LITTLE")
            << " of the energy, balance " << below(5e-3, energy_error(start.energies, end.energies))
            << ", momentum " << below(1e-13, model->momentum_error()) << ", turning "
            << below(1e-3, (turning(end) - turning(start)) / (start.bodies[0].mass * 10. * 0.3))
            << ", penetration " << below(0.05, penetration) << '\n';
}

/// A grain on the bottom, below a top wall with these parameters.
std::string below_wall(const std::string &top)
{
  return grain_scene(disks({{"0, 0", "0; 0"}}, "10") + R"(
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, -10.6
  end
  subsection top
    set Drive = pressure
    set Pressure = 0.02
)" + top + R"(
  end
  subsection left
    set Point = -20, 0
  end
  subsection right
    set Point = 20, 0
  end
end
)");
}

/// A grain on the bottom, pressed by the top wall: the force on both becomes pressure times width, whatever
/// resists the motion of the wall.
void pressed(const std::string &what, const Changes &changes)
{
  const auto model = bpm_scene(below_wall("    set Point = 0, 10.6"), changes);
  const Energies start = model->energies();
  double force = 0., on_top = 0., weight = 0.;
  while (model->time() < 400.)
  {
    const double dt = model->advance(400. - model->time()).dt;
    if (model->time() > 300.)
    {
      force += dt * model->walls()[0].normal_force;
      on_top += dt * model->walls()[1].normal_force;
      weight += dt;
    }
  }
  std::cout << "pressed, " << what << ": force on the bottom over pressure times width "
            << below(0.005, force / weight / (0.02 * 40.) - 1.) << " off, on the top "
            << below(0.005, on_top / weight / (0.02 * 40.) - 1.) << ", top moves with "
            << below(5e-3, model->walls()[1].velocity) << ", energy balance "
            << below(1e-2, energy_error(start, model->energies())) << '\n';
}

/// A wall that meets nobody: what its load does not push, the damping that the program chooses holds,
/// 0.4 times the root of mass times pressure.
void falling_wall()
{
  const auto model = bpm_scene(below_wall("    set Point = 0, 1e4\n    set Mass = 50"), {});
  const double mass = 50., load = 0.02 * 40., damping = 0.4 * std::sqrt(mass * 0.02);
  double before = 0., off = 0.;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const double dt = model->advance(1.).dt, after = model->walls()[1].velocity;
    off = std::max(off, std::abs(mass * (after - before) / dt + damping * after - load) / load);
    before = after;
  }
  std::cout << "wall that meets nobody: Newton's law off by " << below(1e-9, off) << ", damping bears "
            << (damping * before > 1e-3 * load ? "a part" : "NOTHING") << '\n';
}

void fixed_body()
{
  const auto model = bpm_scene(grain_scene(disks({{"-10.6, 0", "0.3; 0"}, {"10.6, 0", "0; 0"}}, "10")),
                               {"Bodies/d1/Driven=true"});
  while (model->time() < 30.)
    model->advance(30. - model->time());
  const Snapshot<2> end = model->snapshot();
  std::cout << "fixed body: its velocity " << end.bodies[1].velocity.norm() << ", the other one's "
            << (end.bodies[0].velocity[0] < 0.1 ? "taken" : "KEPT") << '\n';
}
} // namespace

int main()
{
  bounce("0");
  bounce("0.5");
  bounce("1");
  fast();
  aggregates("head on", "10.6, 0", {});
  aggregates("off centre", "8.6, 10", {});
  aggregates("with friction and rolling resistance", "8.6, 10",
             {"Contact/Friction=0.5", "Contact/Rolling resistance=0.2"});
  const std::string mass = "Walls/top/Mass=", damping = "Walls/top/Damping=";
  pressed("mass and damping as the program chooses", {});
  pressed("given", {mass + "100", damping + "5"});
  pressed("both halved", {mass + "50", damping + "2.5"});
  pressed("damping far above mass over step", {mass + "1", damping + "30"});
  falling_wall();
  fixed_body();
}
