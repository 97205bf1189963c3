// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_touching_pairs_h
#define softgrain_analysis_touching_pairs_h

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace softgrain
{
/**
 * @brief Who touches whom: bodies and walls as pairs, however many places they touch at.
 */
class TouchingPairs
{
public:
  /// A contact that carries force between bodies @p a and @p b; contacts inside a body do not count.
  void add_bodies(const std::size_t a, const std::size_t b)
  {
    if (a != b)
      bodies.emplace(std::min(a, b), std::max(a, b));
  }

  /// A contact that carries force between a body and a wall.
  void add_wall(const std::size_t body, const std::size_t wall) { walls.emplace(body, wall); }

  const std::set<std::pair<std::size_t, std::size_t>> &pairs_of_bodies() const { return bodies; }
  const std::set<std::pair<std::size_t, std::size_t>> &pairs_with_walls() const { return walls; }

  /// Mean number of bodies and walls that a body touches: a pair of bodies counts for both.
  double coordination(const std::size_t n_bodies) const
  {
    return n_bodies == 0 ? 0. : (2. * bodies.size() + walls.size()) / n_bodies;
  }

private:
  std::set<std::pair<std::size_t, std::size_t>> bodies, walls;
};
} // namespace softgrain

#endif
