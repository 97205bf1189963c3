// SPDX-License-Identifier: LGPL-2.1-or-later
// A driven disk of speed v takes a free one of mass m along: what drives it does the work m v^2, of which one
// half moves the other disk and one half is lost; it gives the momentum m v. Where a driven
// aggregate rubs energy and momentum balance, too.
#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;

namespace
{
/// Two disks of radius 10, the first driven to the right, the other 1 to the right of it.
std::string scene(const std::string &velocity)
{
  return grain_scene(
      "subsection Bodies\n  set Names = driven, free\n  subsection driven\n    set Radius = 10\n"
      "    set Driven = true\n    set Velocity = " +
      velocity + "\n  end\n  subsection free\n    set Center = 21, 0\n    set Radius = 10\n  end\nend\n");
}

double work_of_driven(const bpm::BpmModel &model)
{
  for (const auto &[name, value] : model.works())
    if (name == "driven_bodies_work_J_per_m")
      return value;
  return std::nan("");
}

void look(const std::string &what, const std::string &text, const Changes &changes, const double until)
{
  const auto model = bpm_scene(text, changes);
  const Energies start = model->energies();
  while (model->time() < until)
    model->advance(until - model->time());
  const Energies now = model->energies();
  std::cout << what << ": energies differ by " << below(1e-3, energy_error(start, now)) << ", momentum by "
            << below(1e-10, model->momentum_error()) << ", work "
            << (std::abs(work_of_driven(*model) - now.external_work) < 1e-12 * now.external_work ? "that"
                                                                                                 : "NOT THAT")
            << " of the driven body\n";
}
} // namespace

int main()
{
  const auto model = bpm_scene(scene("1; 0"), {"Primaries/Number per body=1", "Time/Time step=0.1"});
  const double kinetic = model->energies().kinetic;
  while (model->time() < 50.)
    model->advance(50. - model->time());
  // Of the other disk alone: the driven one keeps its energy.
  const Energies now = model->energies();
  const double gained = now.kinetic - kinetic;
  std::cout << "one disk takes another along: work over what that gained " << work_of_driven(*model) / gained
            << ", lost " << now.dissipated / gained << ", momentum error "
            << below(1e-12, model->momentum_error()) << '\n';

  look("with friction", scene("0.05; 0.02"), {"Contact/Friction=0.5", "Contact/Rolling resistance=0.5"}, 60.);
}
