// SPDX-License-Identifier: LGPL-2.1-or-later
// Thirty disks squeezed until the pores are nearly closed and then left to come to rest: momentum, energy and
// penetration on the way; at rest opposite walls carry the same, and the mean stress of the grains is that of
// the walls.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
/// Squeezes until @p stop; what holds on the way.
std::unique_ptr<mpm::MpmModel> squeeze(const std::string &what, std::vector<std::string> changes)
{
  changes.push_back("Walls/top/Velocity=t < 4.6e-4 ? 5 : 0");
  changes.push_back("Mesh/Cell size=4e-4");
  auto model = shipped_scene("gallery/thirty_grains_mpm.prm", changes);
  EnergyWatch energy(*model);
  double penetration = 0.;
  run_until(*model, 4.6e-4,
            [&](const StepReport &report)
            {
              energy.look(*model);
              penetration = std::max(penetration, report.max_penetration);
            });
  const auto walls = model->walls(); // bottom, top, left, right
  std::cout << what << ": packing fraction "
            << model->solid_area() /
                   ((walls[3].position - walls[2].position) * (walls[1].position - walls[0].position))
            << ", momentum " << below(1e-9, model->momentum_error()) << ", energy from nowhere "
            << below(0.01, energy.gained()) << ", penetration in cells " << below(0.05, penetration / 4e-4)
            << '\n';
  // A marker that is projected on the far side of a neighbour makes a contact whose normal looks away.
  double worst = 1.;
  const Snapshot<2> now = model->snapshot();
  for (const ContactState<2> &contact : now.contacts)
    if (contact.body_b < now.bodies.size())
    {
      const auto line = now.bodies[contact.body_a].center - now.bodies[contact.body_b].center;
      worst = std::min(worst, contact.normal * line / line.norm());
    }
  std::cout << "  " << (now.contacts.size() > 200 ? "more" : "not more")
            << " than 200 contacts, all within 60 degrees of the line of centres: "
            << (worst > 0.5 ? "yes" : "no") << '\n';
  return model;
}

void look_at_rest(mpm::MpmModel &model)
{
  run_until(model, 1.2e-3);
  const Snapshot<2> end = model.snapshot();
  const auto &walls = end.walls;
  const double width = walls[3].position - walls[2].position, height = walls[1].position - walls[0].position;
  dealii::SymmetricTensor<2, 2> stress;
  for (const BodyState<2> &body : end.bodies)
    stress += body.area / (width * height) * body.mean_stress;
  std::cout << "at rest: kinetic over stored energy "
            << below(1e-3, end.energies.kinetic / end.energies.elastic) << ", top over bottom force "
            << walls[1].normal_force / walls[0].normal_force << ", right over left "
            << walls[3].normal_force / walls[2].normal_force << ", stress of grains over that of walls "
            << -2. * width * stress[1][1] / (walls[0].normal_force + walls[1].normal_force) << " across, "
            << -2. * height * stress[0][0] / (walls[2].normal_force + walls[3].normal_force) << " along\n";
}
} // namespace

int main()
{
  squeeze("no friction", {});
  look_at_rest(*squeeze("friction 0.5, backward Euler", {"Contact/Friction=0.5", "Time/Theta=1"}));
}
