// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_obstacle_feet_h
#define softgrain_driving_obstacle_feet_h

#include <softgrain/driving/obstacle.h>

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace softgrain
{
/**
 * @brief Where disks touch obstacles.
 *
 * A line of several pieces is met as one. A disk touches it where the distance to its centre is smaller than
 * at all places of the line beside: inside of a piece, at a free end, or at a corner that stands out towards
 * the disk. The end of a piece behind which the line goes on nearer to the disk is no such place. Taken for
 * one it would stop a disk that slides along a straight row of pieces, for its normal points against the
 * motion.
 *
 * Lines of two obstacles whose ends lie in the same place at the moment go on into each other too.
 */
class ObstacleFeet
{
public:
  /// A place that is touched, or nearly.
  struct Foot
  {
    std::uint32_t obstacle = 0, piece = 0, disk = 0;
    dealii::Point<2> drawn;      ///< the place, as the obstacle is drawn [m]
    dealii::Tensor<1, 2> normal; ///< unit, from the place to the centre of the disk
    double gap = 0;              ///< [m]
  };

  /// @param list of obstacles; it has to stay, and so has the form of its members
  explicit ObstacleFeet(const std::vector<Obstacle<2>> &list);

  /**
   * @brief All feet with gaps up to @p reach [m], where the obstacles are now, in the order of obstacles,
   * pieces and disks.
   *
   * @param centers,radii of disks [m]
   */
  std::vector<Foot> find(const std::vector<std::array<double, 2>> &centers,
                         const std::vector<double> &radii,
                         double reach) const;

  /// How far any of its places goes at most in the step that is planned for obstacle @p o [m].
  double farthest_way(std::size_t o) const;

  /// Distance of a place of the drawn obstacle @p o from its line [m]; anything larger than @p far where it
  /// is farther.
  double distance(std::size_t o, const dealii::Point<2> &drawn, double far) const;

  std::size_t n_pieces(std::size_t o) const { return pieces(o).size(); }

private:
  /// One of the two ends of a piece.
  struct End
  {
    std::uint32_t obstacle, piece;
    bool last;

    bool operator<(const End &other) const
    {
      return std::tie(obstacle, piece, last) < std::tie(other.obstacle, other.piece, other.last);
    }
  };
  /// Everything of a piece, or of a line, lies in it.
  struct Circle
  {
    dealii::Point<2> center; ///< as drawn [m]
    double radius = 0;       ///< [m]
  };
  using Joints = std::vector<std::array<std::optional<End>, 2>>; ///< of the ends of every obstacle's line

  const std::vector<Curve> &pieces(const std::size_t o) const { return obstacles[o].description.pieces; }
  dealii::Point<2> place(const End &end) const;
  bool is_loop(std::size_t o) const;
  /// Which ends of lines lie in the same place now.
  Joints join() const;
  /// What goes on where a piece ends.
  std::optional<End> next(const End &end, const Joints &joints) const;
  /// Whether the line has no place nearer to @p center beside the end of a piece that is nearest in it.
  bool is_touched(const End &end, const dealii::Point<2> &center, const Joints &joints) const;
  static Circle circle_around(const std::vector<Polygon> &lines);

  const std::vector<Obstacle<2>> &obstacles;
  std::vector<Circle> circles;                    ///< around every obstacle
  std::vector<std::vector<Circle>> piece_circles; ///< around every piece
};
} // namespace softgrain

#endif
