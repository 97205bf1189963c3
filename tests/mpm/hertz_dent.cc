// SPDX-License-Identifier: LGPL-2.1-or-later
// Hertz's dent has the slope that differences have, its energy is the work of the force, both without a jump,
// and it ends where the contact is wider than a grid shows.
#include <softgrain/mpm/contact/hertz_dent.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain::mpm;

namespace
{
void dents()
{
  const HertzDent dent(2., 3., 0.5);
  double slope = 0., energy = 0., jump = 0., before = 0.;
  const double widest = 1.8 * 0.5, last = 4. / 3. * 2. * std::pow(widest, 3) / 3.;
  for (double force = 1e-9; force < 1.5 * last; force *= 1.01)
  {
    const double step = 1e-6 * force;
    const double difference = (dent(force + step) - dent(force - step)) / (2. * step);
    // Not where it has a corner.
    if (std::abs(dent.slope(force + step) - dent.slope(force - step)) < 1e-3 * std::abs(dent.slope(force)))
    {
      slope = std::max(slope, std::abs(difference - dent.slope(force)));
      energy =
          std::max(energy, std::abs((dent.energy(force + step) - dent.energy(force - step)) / (2. * step) -
                                    force * difference) /
                               (last * dent.slope(0.)));
    }
    jump = std::max(jump, std::abs(dent(force) - before));
    before = dent(force);
  }
  std::cout << "dents: slope to 1e-6: " << (slope < 1e-6 * dent.slope(0.))
            << ", energy to 1e-6: " << (energy < 1e-6) << ", steps below 1e-3: " << (jump < 1e-3)
            << ", beyond its end " << dent(1.01 * last) << ", none " << HertzDent()(1.) << '\n';
}
} // namespace

int main()
{
  dents();
}
