// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_turning_h
#define softgrain_geometry_turning_h

#include <algorithm>
#include <cmath>

namespace softgrain
{
/**
 * @brief Whether a closed line may meet itself, told by how it turns: backwards by more than 100 degrees
 * somewhere, as in a crease, a notch or a hole, or forwards by more than once around, as where it crosses
 * itself.
 *
 * @param n    number of places along the line
 * @param turn turn(k) is the angle from place k to the next, positive anticlockwise [rad]
 */
template <class Turn>
bool may_meet_itself(const unsigned int n, const Turn &turn)
{
  constexpr double pi = 3.14159265358979323846, backwards = 100. / 180. * pi, most_around = 3. * pi;
  double angle = 0., largest = 0., furthest_back = 0.;
  const auto go_on = [&](const unsigned int k)
  {
    angle += turn(k);
    largest = std::max(largest, angle);
    furthest_back = std::max(furthest_back, largest - angle);
  };
  for (unsigned int k = 0; k < n; ++k)
    go_on(k);
  if (furthest_back > backwards || std::abs(angle) > most_around)
    return true;
  // The line may turn back where its list of places begins.
  for (unsigned int k = 0; k < n && furthest_back > 0.; ++k)
    go_on(k);
  return furthest_back > backwards;
}
} // namespace softgrain

#endif
