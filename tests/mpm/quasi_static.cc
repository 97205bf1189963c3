// SPDX-License-Identifier: LGPL-2.1-or-later
// Thirty loose grains compacted without inertia until they carry the walls, without and with friction: every
// step ends in balance, no step is rejected, no grain lies in another by more than the dents that its cells
// miss (radii are two cells, and the law of dents gives up to .055 cells there), opposite walls carry the
// same without friction, and what walls put in is stored, or taken by contacts and by the regularising
// forces. Looking for balance after every fifth step only, as a run does that writes no other, comes to the
// same stress with fewer held steps, and what walls put in is booked as well.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
/// Of what walls put in, the share that is neither stored nor booked.
double not_booked(const mpm::MpmModel &model)
{
  const Energies energies = model.energies();
  return std::abs(energies.external_work - energies.elastic - energies.dissipated) / energies.external_work;
}

void compact(const std::string &what, const std::vector<std::string> &changes)
{
  std::vector<std::string> all = {"Time/Scheme=quasi_static", "Mesh/Cell size=4e-4", "Contact/Tolerance=1e-8",
                                  "Contact/Algorithm=active_set"};
  all.insert(all.end(), changes.begin(), changes.end());
  const auto model = shipped_scene("gallery/thirty_grains_mpm.prm", all);
  double unbalanced = 0., penetration = 0.;
  unsigned int rejected = 0;
  run_until(*model, 1.6e-4,
            [&](const StepReport &report)
            {
              for (const auto &[name, value] : model->extra_history())
                if (name == "unbalanced_force")
                  unbalanced = std::max(unbalanced, value);
              penetration = std::max(penetration, report.max_penetration);
              rejected += report.attempts - 1;
            });
  const auto walls = model->walls(); // bottom, top, left, right
  const double width = walls[3].position - walls[2].position, height = walls[1].position - walls[0].position;
  std::cout << what << ": packing fraction " << model->solid_area() / (width * height) << ", rejected steps "
            << rejected << ", unbalanced force " << below(1.0001e-4, unbalanced) << ", penetration in cells "
            << below(0.06, penetration / 4e-4) << ", stress on top " << walls[1].normal_force / width
            << " Pa, energy that is neither stored nor booked " << below(0.02, not_booked(*model)) << '\n';
  if (walls[0].normal_force > 0. && changes.empty())
    std::cout << "  top over bottom " << walls[1].normal_force / walls[0].normal_force << ", right over left "
              << walls[3].normal_force / walls[2].normal_force << '\n';
}
double column(const mpm::MpmModel &model, const std::string &wanted)
{
  for (const auto &[name, value] : model.extra_history())
    if (name == wanted)
      return value;
  return -1.;
}

void seldom_in_balance()
{
  double stress[2] = {}, held[2] = {}, unbalanced = 0., seldom_booked = 0.;
  for (const unsigned int every : {1, 5})
  {
    const auto model =
        shipped_scene("gallery/thirty_grains_mpm.prm", {"Time/Scheme=quasi_static", "Mesh/Cell size=4e-4"});
    for (unsigned int step = 1; step <= 20; ++step)
    {
      StepReport report = model->advance(1.);
      if (step % every != 0)
        continue;
      model->settle(report);
      model->settle(report); // once is enough
      unbalanced = std::max(unbalanced, column(*model, "unbalanced_force"));
    }
    stress[every > 1] = model->walls()[1].normal_force;
    held[every > 1] = column(*model, "held_steps");
    seldom_booked = not_booked(*model);
  }
  std::cout << "balance after every fifth step: unbalanced force " << below(1.0001e-4, unbalanced)
            << ", force on top over that with balance after every one, less 1 "
            << below(2e-3, stress[1] / stress[0] - 1.) << ", held steps over those "
            << below(0.75, held[1] / held[0]) << ", energy that is neither stored nor booked "
            << below(0.05, seldom_booked) << '\n';
}
} // namespace

int main()
{
  compact("no friction", {});
  std::vector<std::string> rough = {"Contact/Friction=0.5"};
  for (const std::string wall : {"bottom", "top", "left", "right"})
    rough.push_back("Walls/" + wall + "/Friction=0.5");
  compact("friction 0.5", rough);
  seldom_in_balance();
}
