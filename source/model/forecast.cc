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

Forecast Forecast::of_rank(const unsigned int n) const
{
  const double sharing = std::max(1., std::min<double>(n, divided.pieces));
  const auto part = [sharing](const double divided_part) { return 1. - divided_part * (1. - 1. / sharing); };
  Forecast one = *this;
  one.preparation *= part(divided.preparation);
  one.step_seconds *= part(divided.step);
  one.memory *= part(divided.memory);
  if (n > divided.pieces)
    one.warnings.push_back(std::to_string(n) + " ranks, but there is work for about " +
                           count_in_words(std::max(1., std::floor(divided.pieces))));
  return one;
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
