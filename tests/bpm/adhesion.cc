// SPDX-License-Identifier: LGPL-2.1-or-later
// Primaries of different bodies with tables of pairs: they slide and roll on a wall as their own friction
// says; a contact holds up to its strength; the books of energy balance; bonds break, and heal when they are
// asked to.
#include <deal.II/base/numbers.h>

#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;

namespace
{
/// Bodies of one primary each, of diameter 1 and density 1, with two materials that do not attract.
std::string single(const std::vector<Disk> &all, const std::string &more = "")
{
  return R"(
subsection Materials
  set Names = rough, slick
  subsection rough
    set Density = 1
    subsection Power law
      set Force at contact = 0
    end
  end
  subsection slick
    set Density = 1
    subsection Power law
      set Force at contact = 0
    end
  end
end
subsection Primaries
  set Smallest diameter = 1
  set Largest diameter  = 1
  set Number per body   = 1
end
subsection Stop
  set End time = 1000
end
subsection Time
  set Time step = 0.01
end
)" + disks(all, "0.5") +
         more;
}

const std::string bottom = "subsection Walls\nset Names = bottom\nend\n";

void run(bpm::BpmModel &model, const double end)
{
  while (model.time() < end - 1e-9)
    model.advance(end - model.time());
}

void incline()
{
  const double angle = std::atan(0.4), g = 0.1;
  std::ostringstream gravity;
  gravity.precision(12);
  gravity << "Loads/Gravity=" << g * std::sin(angle) << ", " << -g * std::cos(angle);
  const auto model = bpm_scene(
      single({{"0, 0.5", "0; 0"}, {"-50, 0.5", "0; 0"}, {"-100, 0.5", "0; 0"}}, bottom),
      {gravity.str(), "Bodies/d0/Material=rough", "Bodies/d1/Material=slick", "Bodies/d2/Material=slick",
       "Walls/bottom/Friction=0.5", "Contact/Friction of pairs=slick / bottom: 0.1; bottom / d2: 0.05"});
  run(*model, 10.);
  const Snapshot<2> end = model->snapshot();
  const double rolls = 2. / 3. * g * std::sin(angle);
  std::cout << "incline: the rough disk rolls with " << end.bodies[0].velocity[0] / 10. / rolls
            << ", the slick ones slide with "
            << end.bodies[1].velocity[0] / 10. / (g * (std::sin(angle) - 0.1 * std::cos(angle))) << " and "
            << end.bodies[2].velocity[0] / 10. / (g * (std::sin(angle) - 0.05 * std::cos(angle)))
            << " of the exact accelerations\n";
}

/// A disk under another one that is fixed, pulled by a share of the strength of the pair.
void pull_off(const double share, const std::string &law)
{
  std::ostringstream force;
  force.precision(12);
  force << "Bodies/d1/Body force=0; " << -share * 0.3 / (0.25 * dealii::numbers::PI);
  const auto model =
      bpm_scene(single({{"0, 0", "0; 0"}, {"0, -1", "0; 0"}}),
                {force.str(), "Bodies/d0/Driven=true", "Bodies/d0/Material=rough", "Bodies/d1/Material=slick",
                 "Contact/Law=" + law, "Contact/Adhesion=7", "Contact/Adhesion of pairs=slick / rough: 0.3"});
  run(*model, 5.);
  std::cout << law << ", pulled by " << share
            << " of the strength: " << (model->snapshot().bodies[1].center[1] > -1.0001 ? "holds" : "parts")
            << '\n';
}

/// Two disks that attract each other over a range of 0.2 fly together and, as one is kicked, apart.
void energy(const double dt)
{
  std::ostringstream step;
  step << "Time/Time step=" << dt;
  const auto model =
      bpm_scene(single({{"0, 0", "0; 0"}, {"1, 0", "1; 0"}}),
                {step.str(), "Bodies/d0/Material=rough", "Bodies/d1/Material=rough", "Contact/Law=cohesive",
                 "Contact/Adhesion=0.3", "Contact/Adhesion range=0.2"});
  const Energies start = model->energies();
  run(*model, 2.);
  const Energies end = model->energies();
  double work = 0.;
  for (const auto &[name, value] : model->works())
    if (name == "adhesion_work_J_per_m")
      work = value;
  // The pull acts from contact to the end of its range, and on the last step that begins within it.
  std::cout << "torn apart, step " << dt << ": work of adhesion over strength times range "
            << -work / (0.3 * 0.2) << ", kinetic energy lost over it "
            << (start.kinetic - end.kinetic) / -work << ", dissipated " << below(1e-12, end.dissipated)
            << ", balance " << below(1e-12, energy_error(start, end)) << ", momentum "
            << below(1e-13, model->momentum_error()) << '\n';
}

/// A disk on the bottom is pulled with 0.9 times the strength, with 1.1 times until it is off, pushed back
/// for about three units of time, and pulled with 0.5 of the strength.
void bond(const std::string &title, const Changes &more)
{
  Changes changes = {"Contact/Adhesion=0.7853981634", "Bodies/d0/Material=rough",
                     "Bodies/d0/Body force=0; t < 1 ? 0.9 : t < 1.4 ? 1.1 : t < 5 ? -2 : 0.5"};
  changes.insert(changes.end(), more.begin(), more.end());
  const auto model = bpm_scene(single({{"0, 0.5", "0; 0"}}, bottom), changes);
  std::cout << title << ':';
  for (const double time : {1., 1.4, 5., 7.})
  {
    run(*model, time);
    std::cout << (model->snapshot().bodies[0].center[1] < 0.5 + 1e-3 ? " down" : " up");
  }
  std::cout << '\n';
}

/// A disk without weight on the bottom, pulled sideways: it rolls as long as its bond bears the friction, a
/// third of the force; when that is sheared off, nothing presses it on the wall.
void sheared(const double share)
{
  std::ostringstream force;
  force.precision(12);
  force << "Bodies/d0/Body force=" << share * 3. * 0.2 << "; 0";
  const auto model = bpm_scene(single({{"0, 0.5", "0; 0"}}, bottom),
                               {force.str(), "Contact/Adhesion=0.7853981634", "Bodies/d0/Material=rough",
                                "Contact/Law=bond", "Walls/bottom/Friction=0.2"});
  run(*model, 5.);
  const BodyState<2> body = model->snapshot().bodies[0];
  const double free = share * 3. * 0.2 * 5., rolling = 2. / 3. * free;
  std::cout << "sheared by " << share << " of what it bears: velocity over that of rolling "
            << body.velocity[0] / rolling << ", over that of sliding freely " << body.velocity[0] / free
            << '\n';
}
} // namespace

int main()
{
  incline();
  for (const std::string law : {"cohesive", "bond"})
    for (const double share : {0.99, 1.01})
      pull_off(share, law);
  energy(0.01);
  energy(0.001);
  bond("cohesive", {"Contact/Law=cohesive"});
  bond("bond that never heals", {"Contact/Law=bond"});
  bond("bond that heals at once", {"Contact/Law=bond", "Contact/Healing time=0"});
  bond("bond that heals too late", {"Contact/Law=bond", "Contact/Healing time=4"});
  bond("bond that heals in time", {"Contact/Law=bond", "Contact/Healing time=2"});
  sheared(0.98);
  sheared(1.02);
}
