// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_outline_overlap_h
#define softgrain_geometry_outline_overlap_h

#include <softgrain/geometry/polygon.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace softgrain
{
/**
 * @brief The edge of a body as closed polylines, one after the other in one list of vertices.
 *
 * What lies inside is told by the number of edges that a ray crosses, so that a hole is outside, whichever
 * way round its loop runs. It refers to the lists that it is given.
 */
class Outline
{
public:
  using Place = dealii::Point<2>;

  /// @param vertices   of all loops [m]
  /// @param loop_start first vertex of every loop, and the end
  /// @param box        around the vertices [m]
  Outline(const std::vector<Place> &vertices,
          const std::vector<unsigned int> &loop_start,
          const dealii::BoundingBox<2> &box)
      : vertices(vertices)
      , loop_start(loop_start)
      , lower(box.get_boundary_points().first)
      , upper(box.get_boundary_points().second)
  {
  }

  /// Calls work(begin, end) for every edge.
  template <class Work>
  void for_edges(const Work &work) const
  {
    for (std::size_t l = 0; l + 1 < loop_start.size(); ++l)
      for (unsigned int v = loop_start[l], before = loop_start[l + 1] - 1; v < loop_start[l + 1];
           before = v++)
        work(vertices[before], vertices[v]);
  }

  /// Whether a place lies in the material.
  bool encloses(const Place &x) const;
  /// Distance of a place from the nearest edge [m].
  double distance(const Place &x) const;

  const std::vector<Place> &vertices;
  const std::vector<unsigned int> &loop_start;
  const Place lower, upper; ///< corners of the box around it [m]
};

/// How deep something lies in something else.
struct Intrusion
{
  double depth = 0;       ///< 0: not at all [m]
  dealii::Point<2> place; ///< the deepest [m]

  /// Becomes the deeper of the two; of equal ones this stays.
  void take(const Intrusion &other)
  {
    if (other.depth > depth)
      *this = other;
  }
};

/**
 * @brief How deep two bodies lie in each other: the largest distance from the edge of one, of a place on the
 * edge of the other that lies inside.
 *
 * Vertices are looked at, and where edges cross without any inside, the middles of the stretches between.
 * Two bodies of the same edge exactly lie in each other unseen.
 */
Intrusion deepest_intrusion(const Outline &a, const Outline &b);

/**
 * @brief How deep a body lies in itself, where its outline has folded and crossed itself: the largest
 * distance from a vertex that has material on its outer side to the nearest edge that faces it.
 *
 * The outline must have its material on the left.
 * @param least_way length of outline between two places that count as different parts: the tip of a corner
 * that is turned inside out is shorter [m]
 */
Intrusion deepest_fold(const Outline &outline, double least_way);

/// How far a body lies beyond the plane through @p point with unit @p normal, which points to where it may
/// be.
Intrusion
deepest_beyond(const Outline &outline, const dealii::Point<2> &point, const dealii::Tensor<1, 2> &normal);

/**
 * @brief How deep a line lies in a body: the largest distance from the body's edge of a place of the line.
 * @param line    vertices from the beginning to the end [m]
 * @param spacing of the places that are looked at [m]
 */
Intrusion deepest_within(const Outline &outline, const Polygon &line, double spacing);
} // namespace softgrain

#endif
