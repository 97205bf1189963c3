// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that adds up: exactly, so that no sum depends on who has which primaries.
#include <softgrain/bpm/dynamics.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace softgrain::bpm
{
std::vector<ExactSum> Dynamics::sums_of_motion() const
{
  std::vector<ExactSum> sums(4);
  for (std::size_t i = 0; i < n_own(); ++i)
  {
    const std::array<double, 2> &v = primaries.velocity[i];
    sums[1].add(primaries.mass[i] * std::hypot(v[0], v[1]));
    if (inverse_mass[i] == 0.)
      continue;
    const double spin = rotations ? primaries.radius[i] * primaries.angular_velocity[i] : 0.;
    sums[0].add(0.5 * primaries.mass[i] * (v[0] * v[0] + v[1] * v[1] + 0.5 * spin * spin));
    for (unsigned int d = 0; d < 2; ++d)
      sums[2 + d].add(primaries.mass[i] * v[d]);
  }
  return sums;
}

Dynamics::Totals Dynamics::sum_motion() const
{
  const std::vector<ExactSum> sums = sums_of_motion();
  Totals result;
  result.kinetic = sums[0].value();
  result.moving = sums[1].value();
  result.momentum = dealii::Tensor<1, 2>({sums[2].value(), sums[3].value()});
  return result;
}

std::size_t Dynamics::n_pushing() const
{
  if (share)
    return totals.n_pushing;
  std::size_t n = 0;
  for (std::size_t row = 0; row < rows.size(); ++row)
    n += carries_force(row);
  return n;
}

void Dynamics::sum_up()
{
  std::vector<ExactSum> sums = sums_of_motion();
  std::set<std::uint32_t> walls;
  double pushing = 0.;
  for (std::size_t row = 0; row < rows.size(); ++row)
    pushing += carries_force(row);
  for (std::size_t row = pair_of_row.size(); row < rows.size(); ++row)
    walls.insert(rows.b[row]);
  std::vector<double> here = {deepest, static_cast<double>(list.n_pairs()), static_cast<double>(rows.size()),
                              pushing, static_cast<double>(walls.size())};
  for (const ExactSum &sum : sums)
    sum.pack(here);
  sums.assign(sums.size(), ExactSum());
  totals = Totals();
  exchanges.n_walls = 0;
  for (const std::vector<double> &other : share->of_ranks().of_all(here))
  {
    deepest = std::max(deepest, other[0]);
    totals.n_pairs += static_cast<std::size_t>(other[1]);
    totals.n_contacts += static_cast<std::size_t>(other[2]);
    totals.n_pushing += static_cast<std::size_t>(other[3]);
    exchanges.n_walls += static_cast<unsigned int>(other[4]); // those of the first rank, for others have none
    const double *number = &other[5];
    for (ExactSum &sum : sums)
      sum.add_packed(number);
  }
  totals.kinetic = sums[0].value();
  totals.moving = sums[1].value();
  totals.momentum = dealii::Tensor<1, 2>({sums[2].value(), sums[3].value()});
}
} // namespace softgrain::bpm
