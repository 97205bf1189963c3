// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_shaken_box_h
#define softgrain_packing_shaken_box_h

#include <softgrain/base/random.h>
#include <softgrain/packing/convex_grain.h>

#include <cstdint>
#include <vector>

namespace softgrain
{
/**
 * @brief A box that shrinks about the origin, with convex grains in it that are shaken and never overlap.
 *
 * A Monte Carlo method of hard bodies: every grain in turn is moved and turned a little at random, and stays
 * where it was if it would touch something. Between the rounds the box takes what room there is.
 */
class ShakenBox
{
public:
  using Place = dealii::Point<2>;

  /// @param grains in their places, without overlap @param half of the edges of the box around them [m]
  ShakenBox(std::vector<ConvexGrain> grains, const Place &half);

  /// Shakes until half of the first edge is @p end [m]. @return false when the grains jam before.
  bool shrink(double end, Uniform &random);

  const std::vector<ConvexGrain> &grains() const { return list; }
  const Place &half() const { return edges; }

private:
  void find_neighbours(double way);
  void shake(Uniform &random);
  bool fits(const ConvexGrain &grain) const;
  bool free(std::size_t i, const ConvexGrain &moved) const;
  bool scale(double factor);

  std::vector<ConvexGrain> list;
  Place edges;
  double mean = 0; ///< radius of the circle around a grain
  double step;     ///< largest way of a grain in a round [m]
  std::vector<std::vector<std::uint32_t>> neighbours;
};
} // namespace softgrain

#endif
