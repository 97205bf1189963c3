// SPDX-License-Identifier: LGPL-2.1-or-later
// The distribution (2.32)-(2.33) of the thesis: its integral and mean are one, the fit finds the gamma of
// exact quantiles, and refuses forces of another kind. The densities of the measure are those of a drawing.
#include "configurations.h"

#include <softgrain/analysis/force_distribution.h>

using namespace configurations;

int main()
{
  for (const double gamma : {0.15, 0.25, 0.45, 3.})
  {
    double integral = 0, mean = 0;
    for (int i = 0; i < 200000; ++i)
    {
      const double f = (i + 0.5) * 1e-4;
      integral += force_distribution(f, gamma) * 1e-4;
      mean += f * force_distribution(f, gamma) * 1e-4;
    }
    // The part of forces above f is (1 + gamma) / (1 + gamma exp(beta f)).
    std::vector<double> forces;
    const double beta = force_distribution_beta(gamma);
    const int n = 20000;
    for (int i = 0; i < n; ++i)
      forces.push_back(std::log(((1 + gamma) * n / (n - i - 0.5) - 1) / gamma) / beta);
    std::cout << "gamma " << gamma << ": integral " << integral << ", mean " << mean << ", fit "
              << *fit_force_distribution(forces) << '\n';
  }
  // The values that the thesis reads off its fit.
  std::cout << "beta of 0.45: " << force_distribution_beta(0.45) << '\n';

  std::vector<double> exponential, alike(100, 1.);
  for (int i = 0; i < 1000; ++i)
    exponential.push_back(-std::log((i + 0.5) / 1000) * (1 + (i < 20)));
  std::cout << "fits of forces too wide, too narrow, too few: "
            << fit_force_distribution(exponential).has_value() << fit_force_distribution(alike).has_value()
            << fit_force_distribution(std::vector<double>(19, 1.)).has_value() << '\n';

  // A chain: forces 1, 1, 2, 4 have the mean 2.
  Snapshot<2> chain;
  for (unsigned int i = 0; i < 5; ++i)
    add_ellipse(chain, {2. * i, 0}, 1, 1, 0);
  const double force[4] = {1, 1, 2, 4};
  for (unsigned int i = 0; i < 4; ++i)
    add_contact(chain, i, i + 1, force[i] * 1.02, 0.1);
  for (const auto &[name, value] : MeasureSet({"forces"}).evaluate(chain))
    if (value && *value != 0)
      std::cout << name << " = " << *value << '\n';
}
