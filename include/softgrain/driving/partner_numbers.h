// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_partner_numbers_h
#define softgrain_driving_partner_numbers_h

#include <cstddef>

namespace softgrain
{
/// The numbers by which frames and contact rows name the rigid things that they meet: walls come first, and
/// obstacles count on.
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

private:
  unsigned int n_walls;
};
} // namespace softgrain

#endif
