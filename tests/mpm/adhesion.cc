// SPDX-License-Identifier: LGPL-2.1-or-later
// Adhesion of material points, per length of contact: a block hangs from a wall up to strength times its side
// and falls above, with every scheme; of two blocks torn apart the books of energy balance and tell the work
// of adhesion; a bond that is broken holds no more; in balance adhesion is that of the gaps there are.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
/// Blocks of 1 by 1 cm between walls at the bottom and at the top; they weigh nothing.
std::string scene(const std::string &names, const std::string &bodies)
{
  return R"(
subsection Mesh
  set Lower     = -1e-2, -1e-2
  set Upper     = 2e-2, 4e-2
  set Cell size = 2.1e-3
end
subsection Time
  set Scheme    = moreau_jean
  set Theta     = 1
  set Time step = 1e-3
end
subsection Materials
  set Names = gel
  subsection gel
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e7
    end
  end
end
subsection Walls
  set Names = bottom
end
subsection Contact
  set Law      = cohesive
  set Adhesion = 100
end
subsection Stop
  set End time = 10
end
subsection Bodies
  set Names = )" +
         names + "\n" + bodies + "end\n";
}

std::string block(const std::string &name, const std::string &center, const std::string &more = "")
{
  return "subsection " + name + "\nset Shape = rectangle\nset Size = 1e-2, 1e-2\nset Center = " + center +
         "\n" + more + "end\n";
}

double height(const mpm::MpmModel &model, const unsigned int body)
{
  return model.snapshot().bodies[body].center[1];
}

/// A block on the bottom is pulled upwards, slowly, up to a share of the strength times its side.
void hang(const std::string &title, const double share, const std::vector<std::string> &changes)
{
  std::ostringstream force;
  // 100 N/m^2 hold 10 N/kg times 10 kg/m^2.
  force << "set Body force = 0; min(t, 0.2)/0.2*" << 10. * share << "\n";
  const auto model = scene_of_text(scene("a", block("a", "0, 5e-3", force.str())), changes);
  run_until(*model, 0.3);
  const auto wall = model->walls()[0];
  std::cout << title << ", pulled with " << share << " of the strength: ";
  if (height(*model, 0) > 6e-3)
    std::cout << "parts\n";
  else
    std::cout << "holds, force on the wall over the pull " << wall.normal_force / (-1. * share) << '\n';
}

/// The upper of two blocks flies off the lower one, which sticks to the bottom.
void torn(const std::string &title, const std::vector<std::string> &changes)
{
  const auto model = scene_of_text(
      scene("a, b", block("a", "0, 5e-3") + block("b", "0, 15e-3", "set Velocity = 0; 0.1\n")), changes);
  EnergyWatch energy(*model);
  run_until(*model, 0.03, [&](const StepReport &) { energy.look(*model); });
  double work = 0.;
  for (const auto &[name, value] : model->works())
    if (name == "adhesion_work_J_per_m")
      work = value;
  std::cout << title << ": " << (height(*model, 1) > 16e-3 ? "torn" : "NOT torn")
            << ", work of adhesion over strength, side and range " << -work / (100. * 1e-2 * 2e-4)
            << ", energy " << below(1e-2, energy.error()) << ", momentum "
            << below(1e-9, model->momentum_error()) << '\n';
}

/// Pulled with 1.2 times the strength until it is off, pushed back, and pulled with half of the strength.
void again(const std::string &title, const std::vector<std::string> &changes)
{
  const auto model = scene_of_text(
      scene("a", block("a", "0, 5e-3",
                       "set Body force = 0; t < 0.1 ? 80*t : t < 0.112 ? 12 : t < 0.3 ? -20 : 5\n")),
      changes);
  std::cout << title << ':';
  for (const double time : {0.1, 0.112, 0.3, 0.45})
  {
    run_until(*model, time);
    std::cout << (height(*model, 0) < 5.2e-3 ? " down" : " up");
  }
  std::cout << '\n';
}

/// A disk between plates that go apart, without inertia.
void settled()
{
  std::vector<std::string> changes = {"Mesh/Lower=-6e-3, -6e-3",
                                      "Mesh/Upper=6e-3, 6e-3",
                                      "Mesh/Cell size=5e-4",
                                      "Mesh/Refine near contact=2",
                                      "Material points/Shape function=linear",
                                      "Materials/gel/Neo-Hookean/Young's modulus=2e6",
                                      "Materials/gel/Neo-Hookean/Poisson's ratio=0.3",
                                      "Bodies/disk/Body force=0; 0",
                                      "Contact/Law=cohesive",
                                      "Contact/Adhesion=1.15e5",
                                      "Contact/Adhesion range=3.24e-5",
                                      "Time/Time step=2"};
  for (const char *wall : {"bottom", "top"})
  {
    changes.push_back(std::string("Walls/") + wall + "/Friction=0");
    changes.push_back(std::string("Walls/") + wall + "/Position=2e-6*(t < 5 ? t : 10 - t)");
  }
  const auto model = shipped_scene("verification/partial_slip.prm", changes);
  run_until(*model, 10.);
  std::cout << "in balance, pull " << -model->walls()[0].normal_force << " N/m\n";
}
} // namespace

int main()
{
  for (const double share : {0.97, 1.03})
  {
    hang("theta 1", share, {});
    hang("newmark", share, {"Time/Scheme=newmark", "Time/Theta=0"});
    if (share < 1.) // above there is no balance to be found
      hang("in balance", share, {"Time/Scheme=quasi_static", "Time/Theta=0"});
    hang("explicit", share,
         {"Time/Scheme=explicit", "Time/Theta=0", "Time/Time step=0", "Time/CFL multiple=0.5"});
    hang("with friction", share, {"Walls/bottom/Friction=0.5"});
  }
  const std::vector<std::string> range = {"Contact/Adhesion range=2e-4", "Time/Time step=1e-4",
                                          "Contact/Adhesion of pairs=gel / bottom: 1e4",
                                          "Newton/Residual tolerance=1e-11"};
  torn("theta 1", range);
  std::vector<std::string> half = range;
  half.push_back("Time/Theta=0.5");
  torn("theta 1/2", half);
  again("cohesive", {});
  again("bond", {"Contact/Law=bond"});
  again("bond that heals", {"Contact/Law=bond", "Contact/Healing time=0.05"});
  settled();
}
