// SPDX-License-Identifier: LGPL-2.1-or-later
// Disk on an inclined plane: rolls with 2/3 g sin(angle), or slides with g (sin - mu cos) while it spins up.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
void roll(const std::string &mu, const std::string &cell, const std::string &modulus = "1e4")
{
  constexpr double g = 10., R = 5e-3;
  const double angle = std::atan(0.2), m = std::stod(mu);
  const auto model = shipped_scene("verification/disk_on_incline.prm",
                                   {"Walls/bottom/Friction=" + mu, "Mesh/Cell size=" + cell,
                                    "Materials/gel/Neo-Hookean/Young's modulus=" + modulus});
  EnergyWatch energy(*model);
  const auto look = [&](const StepReport &) { energy.look(*model); };
  run_until(*model, 0.08, look);
  const BodyState<2> first = model->snapshot().bodies[0];
  run_until(*model, 0.16, look);
  const BodyState<2> last = model->snapshot().bodies[0];
  const bool rolls = 0.2 < 3. * m;
  const double exact = rolls ? 2. / 3. * g * std::sin(angle) : g * (std::sin(angle) - m * std::cos(angle));
  // Friction acts at the flattened side, a little nearer to the centre than R.
  const double spin = rolls ? exact / R : 2. * m * g * std::cos(angle) * last.center[1] / (R * R);
  // The angular momentum is that of the disk that turns clockwise down the plane.
  const double inertia = 0.5 * last.mass * R * R;
  std::cout << "mu " << mu << " h " << cell << " E " << modulus << (rolls ? ": rolls" : ": slides")
            << ", acceleration over the exact " << (last.velocity[0] - first.velocity[0]) / 0.08 / exact
            << ", angular acceleration over the exact "
            << (first.angular_momentum - last.angular_momentum) / 0.08 / inertia / spin << ", energy "
            << below(1e-2, energy.error()) << ", momentum " << below(1e-9, model->momentum_error()) << '\n';
}
} // namespace

int main(int argc, char **)
{
  const std::string cell = argc > 1 ? "5e-4" : "1e-3";
  roll("0.3", cell);
  roll("0.03", cell);
  // Less flattened, hence with a rolling radius nearer to R.
  if (argc > 1)
    roll("0.3", cell, "4e4");
}
