// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_partner_numbers_h
#define softgrain_analysis_partner_numbers_h

#include <cstddef>

namespace softgrain
{
/// The numbers by which frames, contact rows and contacts name the rigid things that they meet: walls come
/// first, and obstacles count on.
class PartnerNumbers
{
public:
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  explicit PartnerNumbers(const std::size_t n_walls) : n_walls(n_walls) {}

  bool is_wall(const unsigned int number) const { return number < n_walls; }
  bool is_obstacle(const unsigned int number) const { return number != none && number >= n_walls; }
  /// Which obstacle has that number; none: it is no obstacle's.
  unsigned int obstacle(const unsigned int number) const
  {
    return is_obstacle(number) ? number - n_walls : none;
  }
  unsigned int of_obstacle(const unsigned int obstacle) const { return n_walls + obstacle; }
  /// Whether something has that number among walls and @p n_obstacles.
  bool is_one(const unsigned int number, const std::size_t n_obstacles) const
  {
    return number < n_walls + n_obstacles;
  }

private:
  unsigned int n_walls;
};
} // namespace softgrain

#endif
