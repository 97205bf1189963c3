// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/model/forecast.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
/// @p value to two digits in the largest of the units that it fills.
std::string in_units(const double value, const std::vector<std::pair<double, std::string>> &units)
{
  std::size_t u = 0;
  while (u + 1 < units.size() && value >= units[u + 1].first)
    ++u;
  const double amount = value / units[u].first;
  const double grain = amount > 0. ? std::pow(10., std::floor(std::log10(amount)) - 1.) : 1.;
  std::ostringstream text;
  text << grain * std::round(amount / grain) << units[u].second;
  return text.str();
}
} // namespace

double RunOutline::n_steps(const double dt) const
{
  constexpr double slack = 1. - 1e-6;
  const double every = output_every > 0. ? std::min(output_every, duration) : duration;
  if (!(every > 0.) || !(dt > 0.))
    return 0.;
  return std::ceil(duration / every * std::ceil(every / dt * slack) * slack);
}

std::string count_in_words(const double number)
{
  return in_units(number, {{1., ""}, {1e6, " million"}, {1e9, " thousand million"}});
}

std::string bytes_in_words(const double bytes)
{
  return in_units(bytes, {{1e6, " MB"}, {1e9, " GB"}, {1e12, " TB"}});
}
} // namespace softgrain
