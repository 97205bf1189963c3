// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces that only push: on a rigid bar on springs whose end is lifted, some places open, and the others are
// solved for alone; on random places no force pulls, no gap is negative, and one of both is zero. Hertz's
// dent has the slope that differences have, its energy is the work of the force, both without a jump, and it
// ends where the contact is wider than a grid shows.
#include <softgrain/mpm/contact/hertz_dent.h>
#include <softgrain/mpm/contact/one_sided_forces.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace softgrain::mpm;

namespace
{
void two_places()
{
  OneSidedForces contact;
  contact.compliance = Eigen::Matrix2d({{2., -1.}, {-1., 2.}});
  contact.gap = Eigen::Vector2d(-3., 4.);
  contact.closed = {1, 1};
  const bool found = contact.solve(1e-12);
  std::cout << "two places: " << found << ' ' << contact.force.transpose() << " in " << contact.passes
            << " passes\n";
  contact.compliance = Eigen::Matrix2d({{-1., 0.}, {0., 2.}});
  contact.closed = {1, 1};
  std::cout << "negative eigenvalues " << contact.n_negative() << '\n';
}

void many_places()
{
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  double worst = 0.;
  unsigned int most = 0;
  for (unsigned int trial = 0; trial < 20; ++trial)
  {
    constexpr unsigned int n = 30;
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(n, n + 10, [&]() { return number(random); });
    OneSidedForces contact;
    contact.compliance = A * A.transpose();
    contact.gap = Eigen::VectorXd::NullaryExpr(n, [&]() { return number(random); });
    contact.closed.assign(n, 0);
    if (!contact.solve(1e-12))
      std::cout << "not solved\n";
    const Eigen::VectorXd gap = contact.gap + contact.compliance * contact.force;
    most = std::max(most, contact.passes);
    worst = std::max({worst, -gap.minCoeff(), -contact.force.minCoeff(),
                      gap.cwiseProduct(contact.force).cwiseAbs().maxCoeff()});
  }
  std::cout << "twenty problems: conditions met to 1e-9: " << (worst < 1e-9)
            << ", in less than 40 passes: " << (most < 40) << '\n';
}

void dents()
{
  const HertzDent dent(2., 3., 0.5);
  double slope = 0., energy = 0., jump = 0., before = 0.;
  const double widest = 0.75 * 0.5 / 1.1, last = 4. / 3. * 2. * std::pow(widest, 3) / 3.;
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
  two_places();
  many_places();
  dents();
}
