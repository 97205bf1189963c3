// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_shaken_balls_h
#define softgrain_packing_shaken_balls_h

#include <softgrain/base/random.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace softgrain
{
/**
 * @brief Hard balls, in the plane disks, in a box about the origin that shrinks as far as they leave it room,
 * shaken at random and never in each other.
 *
 * A Monte Carlo method: balls move a little, and now and then two of them change places, whatever their
 * sizes. The latter finds denser packings than pressing alone, which jams at the first that carries its
 * sides.
 */
template <int dim>
class ShakenBalls
{
public:
  using Place = std::array<double, dim>;

  /// @param places without overlap @param half of the edges of the box [m] @param periodic directions without
  /// walls
  ShakenBalls(std::vector<Place> places,
              std::vector<double> radii,
              const Place &half,
              const std::array<bool, dim> &periodic);

  /// Shakes until half of the first edge is @p end [m]; the box takes all the room that there is as long as
  /// that half is above @p dense, and little of it from there on. @return whether it came to the end
  bool shrink(double end, double dense, Uniform &random);

  const std::vector<Place> &places() const { return centers; }
  double scale() const { return edges[0]; } ///< half of the first edge [m]

private:
  using Cell = std::array<int, dim>;

  void fill_cells();
  Cell cell_around(const Place &place) const;
  std::size_t index_of(const Cell &cell) const;
  /// Vector between two places, to the nearest image over the sides without walls.
  Place apart(const Place &a, const Place &b) const;
  bool inside(const Place &place, double radius) const;
  /// Calls work(j) for all balls in the cells around @p place, until it returns false. @return whether it
  /// never did
  template <class Work>
  bool around(const Place &place, const Work &work) const;
  bool is_free(std::size_t i, const Place &place, double radius) const;
  bool move(std::size_t i, const Place &way);
  bool swap(std::size_t i, std::size_t j);
  /// Factor by which the box may become smaller, at most 1.
  double room() const;
  void scale_by(double factor);

  std::vector<Place> centers;
  std::vector<double> radius;
  Place edges;
  std::array<bool, dim> periodic;
  double mean, largest; ///< radius
  double step;          ///< largest way of a ball [m]
  Cell n_cells{};
  std::vector<std::vector<std::uint32_t>> cells;
  std::vector<std::size_t> cell; ///< of every ball
};

extern template class ShakenBalls<2>;
extern template class ShakenBalls<3>;
} // namespace softgrain

#endif
