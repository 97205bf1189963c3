// SPDX-License-Identifier: LGPL-2.1-or-later
// A perfectly plastic block between smooth plates in plane strain bears 2/sqrt(3) of its yield stress, which
// is Kirchhoff's: Cauchy's is larger by 1/det F. With hardening H that of S_y + H alpha.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
void press(const double hardening)
{
  std::ostringstream change;
  change << "Materials/metal/J2 plastic/Hardening modulus=" << hardening;
  const auto model = shipped_scene("verification/plastic_block.prm", {change.str(), "Time/Time step=5e-3"});
  run_until(*model, 0.03);
  const Snapshot<2> state = model->snapshot();
  const double force = model->walls()[1].normal_force, height = 10e-3 * std::exp(-0.03),
               area = state.bodies[0].area;
  double alpha = 0.;
  for (const NamedField &field : state.points.extra)
    if (field.name == "equivalent_plastic_strain")
      for (const double value : field.values)
        alpha += value / field.values.size();
  const double stress = force * height / area, strength = 200e6 + hardening * alpha;
  std::cout << "H/S_y " << hardening / 200e6 << ": stress of Kirchhoff / strength "
            << stress * area / 1e-4 / strength << ", plastic strain / expected "
            << alpha / (2 / std::sqrt(3.) * (0.03 - 0.91 * stress / 200e9)) << '\n';
}
} // namespace

int main()
{
  press(0.);
  press(100e6);
}
