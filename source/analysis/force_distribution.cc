// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/force_distribution.h>

#include <cmath>

namespace softgrain
{
namespace
{
double log_likelihood(const std::vector<double> &forces, const double log_gamma)
{
  const double gamma = std::exp(log_gamma), beta = force_distribution_beta(gamma);
  double sum = forces.size() * std::log(beta * (1. + gamma));
  for (const double f : forces)
  {
    const double x = log_gamma + beta * f; // of gamma exp(beta f) / (1 + gamma exp(beta f))^2
    sum -= std::abs(x) + 2. * std::log1p(std::exp(-std::abs(x)));
  }
  return sum;
}
} // namespace

double force_distribution_beta(const double gamma)
{
  return (1. + gamma) * std::log1p(1. / gamma);
}

double force_distribution(const double f, const double gamma)
{
  const double beta = force_distribution_beta(gamma), decay = std::exp(-beta * f) / gamma;
  return beta * (1. + gamma) * decay / ((1. + decay) * (1. + decay));
}

std::optional<double> fit_force_distribution(const std::vector<double> &forces)
{
  if (forces.size() < 20)
    return std::nullopt;
  // The best of a coarse row of values, then the golden section between its neighbours.
  const double lower = std::log(1e-6), upper = std::log(1e3);
  constexpr int n = 60;
  int best = 0;
  double best_value = log_likelihood(forces, lower);
  for (int i = 1; i <= n; ++i)
  {
    const double value = log_likelihood(forces, lower + i * (upper - lower) / n);
    if (value > best_value)
    {
      best = i;
      best_value = value;
    }
  }
  if (best == 0 || best == n)
    return std::nullopt;
  double a = lower + (best - 1) * (upper - lower) / n, b = lower + (best + 1) * (upper - lower) / n;
  const double ratio = 0.5 * (std::sqrt(5.) - 1.);
  while (b - a > 1e-8)
  {
    const double c = b - ratio * (b - a), d = a + ratio * (b - a);
    if (log_likelihood(forces, c) > log_likelihood(forces, d))
      b = d;
    else
      a = c;
  }
  return std::exp(0.5 * (a + b));
}
} // namespace softgrain
