// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/model/load_balance.h>

#include <algorithm>
#include <numeric>

namespace softgrain::mpm
{
namespace
{
constexpr double tolerated = 1.1; ///< busiest owner over the mean
constexpr unsigned int steps_a_look = 10;
constexpr double kept = 0.5; ///< of what was measured before: a single look may be disturbed

double most_over_mean(const std::vector<double> &of_owners)
{
  const double sum = std::accumulate(of_owners.begin(), of_owners.end(), 0.);
  return sum > 0. ? *std::max_element(of_owners.begin(), of_owners.end()) * of_owners.size() / sum : 1.;
}
} // namespace

bool LoadBalance::uneven(const Exchange &exchange)
{
  if (exchange.alone())
    return false;
  if (late.empty())
  {
    begin(exchange);
    return false;
  }
  if (++steps < steps_a_look)
    return false;
  steps = 0;
  now.clear();
  for (const std::vector<double> &of_owner : exchange.of_all({exchange.taken().own - own_before}))
    now.push_back(of_owner[0]);
  own_before = exchange.taken().own;
  for (unsigned int r = 0; r < now.size(); ++r)
    late[r] = kept * late[r] + now[r];
  if (imbalance() > tolerated)
    return true;
  lost = 0.;
  return false;
}

double LoadBalance::imbalance() const
{
  return most_over_mean(late);
}

std::vector<double> LoadBalance::measured(const BodyShare &share) const
{
  std::vector<double> thought(late.size(), 0.);
  for (unsigned int b = 0; b < costs.size(); ++b)
    thought[share.owner(b)] += costs[b];
  std::vector<double> result = costs;
  for (unsigned int b = 0; b < costs.size(); ++b)
    if (const unsigned int r = share.owner(b); thought[r] > 0. && late[r] > 0.)
      result[b] *= late[r] / thought[r];
  return result;
}

double LoadBalance::imbalance_of(const std::vector<double> &costs,
                                 const std::vector<unsigned int> &owners,
                                 const unsigned int n_owners)
{
  std::vector<double> of_owners(n_owners, 0.);
  for (unsigned int b = 0; b < costs.size(); ++b)
    of_owners[owners[b]] += costs[b];
  return most_over_mean(of_owners);
}

bool LoadBalance::pays(const double expected)
{
  const double better = imbalance() / expected;
  if (better <= tolerated)
    return false;
  lost += *std::max_element(now.begin(), now.end()) * (1. - 1. / better);
  // Before the first change it is thought to take as long as a step.
  const double mean = std::accumulate(now.begin(), now.end(), 0.) / now.size();
  return lost > (price > 0. ? price : mean / steps_a_look);
}

void LoadBalance::moved(std::vector<double> measured, const Exchange &exchange, const double seconds)
{
  costs = std::move(measured);
  price = seconds;
  lost = 0.;
  begin(exchange);
}

void LoadBalance::begin(const Exchange &exchange)
{
  steps = 0;
  late.assign(exchange.number(), 0.);
  own_before = exchange.taken().own;
}
} // namespace softgrain::mpm
