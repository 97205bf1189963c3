// SPDX-License-Identifier: LGPL-2.1-or-later
// Schemes for contact with inertia on problems with exact solutions: a bar that meets a wall (exactly:
// pressure ρ c v for 2 L/c, restitution 1), one that meets another of twice its length (restitution 1/2), one
// that bounces, and a block that slides. With the argument `tables` it prints those of
// doc/results/contact-schemes.md.
#include "contact_schemes/tables.h"

#include <iostream>

using namespace softgrain::schemes;

namespace
{
/// What the page is about, in few numbers; all of them depend on nothing but the schemes.
void short_check()
{
  for (const Variant &variant : variants())
    for (const double cfl : {1., 5., 50.})
    {
      const Summary wall = impact_of(bar_meets_wall, variant, cfl);
      std::cout << variant.words() << ", CFL " << cfl << ": energy ";
      // Growth without bound: the figure says nothing.
      if (wall.gained > 0.5)
        std::cout << "grows, ";
      else
        std::cout << wall.gained + 1. << " at most, " << wall.kept + 1. << " at the end, ";
      std::cout << "penetration " << softgrain::below(1e-9, wall.penetration);
      if (wall.gained < 0.5)
        std::cout << ", restitution " << wall.restitution << ", noise " << wall.noise;
      std::cout << '\n';
    }
}

void check_exact_and_small_steps()
{
  const ExactBar exact({10., 900., 1., 5., 0., 10.}, 4.);
  std::cout << "falling bar: contact from " << exact.contacts[0].start << " to " << exact.contacts[0].end
            << '\n';
  for (const std::string &name : scheme_names())
    if (name != "newmark")
      std::cout << name << ": two bars, restitution "
                << impact_of(bar_meets_bar, {name, Mass::lumped}, 1.).restitution << "; four bounces, energy "
                << 1. + bouncing_bar(name, Mass::lumped, 2., 12.).kept << ", error of u to 3 s "
                << bouncing_bar(name, Mass::lumped, 2., 3.).displacement << '\n';
}

/// Of theta, and of damping by generalised alpha with contact over the whole step, which without damping is
/// kane.
void check_damping()
{
  for (const std::string name :
       {"softgrain 0.5", "softgrain 0.51", "softgrain 1", "whole_step 1", "whole_step 0"})
  {
    const Summary wall = impact_of(bar_meets_wall, {name, Mass::lumped}, 10.);
    std::cout << name << ", CFL 10: energy " << 1. + wall.gained << " at most, " << 1. + wall.kept
              << " at the end, contact took " << wall.contact_took << '\n';
  }
}

void check_friction()
{
  for (const std::string name : {"newmark", "kane", "alpha", "moreau_jean", "softgrain", "softgrain 0.8"})
  {
    const Slide block = worst_decelerating_block(name, 30.), oscillator = oscillating_block(name, 100.);
    std::cout << name << ": way of a block, error " << block.place << ", velocity that stays "
              << softgrain::below(1e-9, block.chatter) << "; oscillator, error " << oscillator.place
              << ", creep " << softgrain::below(1e-9, oscillator.creep) << '\n';
  }
}

/// The program with hats is the scheme "softgrain" on the bar of finite elements with lumped mass.
void check_program()
{
  for (const double cfl : {5., 50.})
  {
    const ImpactMeasures program = program_bar_meets_wall(cfl, 0.3, {"Material points/Shape function=linear"})
                                       .measures,
                         copy = bar_meets_wall("softgrain", Mass::lumped, cfl, 0.3);
    std::cout << "program, CFL " << cfl << ": energy at the end " << 1. + program.kept << ", of the copy "
              << 1. + copy.kept << "; restitution " << program.restitution << ", " << copy.restitution
              << "; noise " << program.noise() << ", " << copy.noise() << "; penetration "
              << softgrain::below(1e-6, program.penetration) << '\n';
  }
}
} // namespace

int main(int argc, char **argv)
{
  if (argc > 1 && std::string(argv[1]) == "tables")
  {
    print_tables();
    return 0;
  }
  short_check();
  check_exact_and_small_steps();
  check_damping();
  check_friction();
  check_program();
}
