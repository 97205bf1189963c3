// SPDX-License-Identifier: LGPL-2.1-or-later
// Block on an inclined plane: sticks just below tan(angle) = mu, slips just above, with g (sin - mu cos).
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
double speed(const mpm::MpmModel &model)
{
  const auto &body = model.bodies()[0];
  return body.nodes.momentum()[0] / body.nodes.mass.sum();
}

void slide(const double ratio, const std::string &mu, const double begin)
{
  const double tangent = ratio * std::stod(mu), angle = std::atan(tangent);
  std::ostringstream gravity;
  gravity.precision(12);
  gravity << "Loads/Gravity=" << 10. * std::sin(angle) << ", " << -10. * std::cos(angle);
  const auto model = shipped_scene("verification/sliding_block.prm",
                                   {gravity.str(), "Walls/bottom/Friction=" + mu, "Mesh/Cell size=2.1e-3"});
  // The load comes at once, so the block slips a little before it has found its weight; what counts is what
  // follows.
  run_until(*model, begin);
  const double before = speed(*model);
  run_until(*model, begin + 0.04);
  const double acceleration = (speed(*model) - before) / 0.04,
               exact = std::max(0., 10. * (std::sin(angle) - std::stod(mu) * std::cos(angle)));
  const auto wall = model->walls()[0];
  std::cout << "mu " << mu << ", tan " << ratio << " mu: ";
  if (exact == 0.)
    std::cout << "speed " << below(1e-5, speed(*model));
  else
    std::cout << "acceleration over the exact " << acceleration / exact;
  std::cout << ", T/N of the wall " << wall.tangential_force / wall.normal_force << ", N over the weight "
            << wall.normal_force / (10. * std::cos(angle) * model->bodies()[0].nodes.mass.sum())
            << ", momentum " << below(1e-10, model->momentum_error()) << '\n';
}
} // namespace

int main()
{
  for (const double ratio : {0.5, 0.99, 1.01, 1.5})
    slide(ratio, "0.3", 0.04);
  // With more friction the block rocks longer.
  for (const double ratio : {0.99, 1.01})
    slide(ratio, "1", 0.2);
}
