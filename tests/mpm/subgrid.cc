// SPDX-License-Identifier: LGPL-2.1-or-later
// Line contact on a grid of six cells over the disk, with and without the dent that the grid misses, against
// Johnson's force (Contact Mechanics, section 5.6), the disk moved by parts of a cell.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double R = 5e-3, E = 10e6, nu = 0.45;

double johnson(const double approach)
{
  const double c = (1. - nu * nu) / (M_PI * E);
  double low = 1e-3, high = 1e5;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const double F = 0.5 * (low + high), a = std::sqrt(4. * F * R * c);
    (F * c * (2. * std::log(4. * R / a) - 1.) < approach ? low : high) = F;
  }
  return low;
}

void press(const std::string &subgrid, const std::string &friction = "0")
{
  const std::vector<double> approaches = {0.005, 0.01, 0.02};
  std::vector<double> mean(3, 0.), worst(3, 0.);
  const std::vector<double> cuts = {0., 0.25, 0.5, 0.75};
  for (const double cut : cuts)
  {
    const std::string lower = std::to_string(-10.2e-3 - cut * 1.7e-3);
    const auto model = shipped_scene("verification/line_contact.prm",
                                     {"Mesh/Cell size=1.7e-3", "Mesh/Lower=" + lower + ", " + lower,
                                      "Mesh/Upper=10.2e-3, 10.2e-3", "Contact/Sub-grid compliance=" + subgrid,
                                      "Walls/bottom/Friction=" + friction, "Walls/top/Friction=" + friction});
    for (unsigned int i = 0; i < 3; ++i)
    {
      run_until(*model, approaches[i]);
      const double error = model->walls()[1].normal_force / johnson(approaches[i] * R) - 1.;
      mean[i] += error / cuts.size();
      worst[i] = std::max(worst[i], std::abs(error));
    }
  }
  for (unsigned int i = 0; i < 3; ++i)
    std::cout << "sub-grid compliance " << subgrid << ", friction " << friction << ", d/R " << approaches[i]
              << ": force over Johnson's less 1, mean " << mean[i] << ", worst " << worst[i] << '\n';
}
} // namespace

int main()
{
  press("true");
  press("false");
  // Rough plates hold the material beside the contact: a little stiffer.
  press("true", "0.5");
}
