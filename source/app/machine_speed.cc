// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/machine_speed.h>
#include <softgrain/base/rank_times.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace softgrain
{
namespace
{
/// Seconds on the machine that the constants of forecasts were fitted on.
namespace reference
{
constexpr double factorisation = 1.2e-3, scattered_sums = 0.58e-3;
} // namespace reference

/// Cholesky's method for a dense matrix. @return a number that depends on all of it
double factorise(const unsigned int n)
{
  std::vector<double> a(n * n, 0.1);
  for (unsigned int i = 0; i < n; ++i)
    a[i * n + i] = n;
  for (unsigned int j = 0; j < n; ++j)
  {
    double *const column = &a[j * n];
    const double root = std::sqrt(column[j]);
    for (unsigned int i = j; i < n; ++i)
      column[i] /= root;
    for (unsigned int k = j + 1; k < n; ++k)
      for (unsigned int i = k; i < n; ++i)
        a[k * n + i] -= column[k] * column[i];
  }
  return a.back();
}

/// Numbers of @p values are added up, each where a generator of random numbers says.
double add_scattered(std::vector<double> &values, const unsigned int n)
{
  std::uint64_t random = 1;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    random = 6364136223846793005u * random + 1442695040888963407u;
    double &value = values[(random >> 33) % values.size()];
    sum += value;
    value = 0.5 * (value + sum / n);
  }
  return sum;
}

/// Least processor time of some calls of @p work [s]: whatever disturbs makes one longer. What it returns
/// goes to @p result.
template <typename Work>
double least_seconds(double &result, const Work &work)
{
  std::array<double, 15> seconds;
  for (double &one : seconds)
  {
    const double begin = processor_seconds();
    result += work();
    one = processor_seconds() - begin;
  }
  return *std::min_element(seconds.begin(), seconds.end());
}
} // namespace

double slowness_of_machine()
{
  double result = 0.;
  // As much as stays in the caches of one core: beyond them the measured time is that of the neighbours'
  // doings at this moment.
  std::vector<double> values(1 << 18, 1.);
  const double factorisation = least_seconds(result, [] { return factorise(400); }),
               sums = least_seconds(result, [&values] { return add_scattered(values, 1 << 19); });
  // A result that nobody looks at need not be computed.
  if (!std::isfinite(result))
    return 1.;
  return std::sqrt(factorisation / reference::factorisation * sums / reference::scattered_sums);
}
} // namespace softgrain
