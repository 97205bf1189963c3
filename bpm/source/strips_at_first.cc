// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of StripShare that brings what ranks have to the first one.
#include <softgrain/bpm/strip_share.h>

#include <algorithm>

namespace softgrain::bpm
{
std::vector<double>
StripShare::at_first(const double *const values, const unsigned int n, const Primaries &disks) const
{
  // One rank after the other, so that the first one holds little more than the result.
  if (!exchange.first())
  {
    std::vector<double> numbers(disks.number.begin(), disks.number.begin() + n_own_primaries),
        own(values, values + n * n_own_primaries);
    for (std::vector<double> *const list : {&numbers, &own})
      if (!list->empty())
        exchange.swap({{0, list->data(), list->size()}}, {});
    return {};
  }
  std::vector<double> all(n * n_primaries);
  for (std::size_t i = 0; i < n_own_primaries; ++i)
    std::copy_n(values + n * i, n, &all[static_cast<std::size_t>(n) * disks.number[i]]);
  for (unsigned int r = 1; r < exchange.number(); ++r)
  {
    std::vector<double> numbers(n_own_of[r]), came(n * numbers.size());
    for (std::vector<double> *const list : {&numbers, &came})
      if (!list->empty())
        exchange.swap({}, {{r, list->data(), list->size()}});
    for (std::size_t i = 0; i < numbers.size(); ++i)
      std::copy_n(&came[n * i], n, &all[n * static_cast<std::size_t>(numbers[i])]);
  }
  return all;
}

std::vector<double> StripShare::tiles_at_first(const std::vector<double> &values,
                                               const std::size_t n_first) const
{
  const double size = values.size(), of_first = n_first;
  const std::vector<std::vector<double>> sizes = exchange.of_all({of_first, size - of_first});
  std::vector<double> all;
  if (exchange.first())
  {
    double sum = 0.;
    for (const std::vector<double> &one : sizes)
      sum += one[0] + one[1];
    all.resize(static_cast<std::size_t>(sum));
  }
  std::vector<Exchange::Piece> pieces;
  double *place = all.data();
  for (unsigned int colour = 0; colour < 2; ++colour)
    for (unsigned int r = 0; r < exchange.number(); ++r)
    {
      const auto n = static_cast<std::size_t>(sizes[r][colour]);
      double *const here = const_cast<double *>(values.data()) + (colour > 0 ? n_first : 0); // is only sent
      if (exchange.first() && r == 0)
        std::copy_n(here, n, place);
      pieces.push_back({r, exchange.first() ? place : here, n});
      place += exchange.first() ? n : 0;
    }
  exchange.bring(pieces);
  return all;
}
} // namespace softgrain::bpm
