// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_convex_hull_h
#define softgrain_geometry_convex_hull_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace softgrain
{
/**
 * @brief The smallest convex body that holds some points: a polyhedron, or where all points lie in a plane,
 * on a line or in one place a polygon with two faces, a line or a point.
 */
struct ConvexHull
{
  struct Face
  {
    dealii::Tensor<1, 3> normal;       ///< unit, outward
    std::vector<unsigned int> corners; ///< counter-clockwise when seen from outside
  };

  struct Edge
  {
    std::array<unsigned int, 2> ends;
    double turn; ///< angle between the normals of its faces; once around where it has none [rad]
  };

  /// The place of the body that is nearest to another one, and what that place is a part of.
  struct Foot
  {
    dealii::Tensor<1, 3> off; ///< from there to the other place [m]
    enum class On
    {
      face,
      edge,
      corner
    } on = On::corner;
    dealii::Tensor<1, 3> along; ///< unit, of the edge
  };

  ConvexHull() = default;
  /// @param points at least one [m]; any may lie inside of the body. It takes n^4 comparisons of n points.
  explicit ConvexHull(const std::vector<dealii::Point<3>> &points);

  /// How deep a place lies inside, 0 on the surface and outside [m].
  double depth(const dealii::Point<3> &x) const;

  /// The place nearest to one with depth() = 0.
  Foot foot(const dealii::Point<3> &x) const;

  double volume() const; ///< [m^3]
  double area() const;   ///< of all faces [m^2]

  std::vector<dealii::Point<3>> corners; ///< [m]
  std::vector<Face> faces;
  std::vector<Edge> edges;

private:
  void find_faces(const std::vector<dealii::Point<3>> &points, double size);
  void find_edges();
  /// Drops the points that no face or edge has.
  void keep_corners(const std::vector<dealii::Point<3>> &points);

  bool solid = false; ///< it has a volume
};
} // namespace softgrain

#endif
