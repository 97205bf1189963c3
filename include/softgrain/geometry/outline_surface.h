// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_outline_surface_h
#define softgrain_geometry_outline_surface_h

#include <softgrain/geometry/rest_surface.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Closed curves through the vertices of outlines, the solid to their left.
 *
 * Between two corners, or all around where there is none, the curve is the cubic spline over the length of
 * chords: tangents and curvatures do not jump at vertices. At a corner it ends without curvature, so sides of
 * polygons are straight. On a circle with n vertices it is off by less than 30/n^4 of the radius.
 */
class OutlineSurface : public RestSurface<2>
{
public:
  using Place = SurfacePlace<2>;
  using Vector = dealii::Tensor<1, 2>;

  OutlineSurface() = default;

  /// @param vertices   of all loops, one after the other [m]
  /// @param loop_start the first vertex of every loop, and the end
  /// @param corner     of every vertex: whether the outline has a corner there
  OutlineSurface(std::vector<dealii::Point<2>> vertices,
                 const std::vector<unsigned int> &loop_start,
                 std::vector<char> corner);

  /// The place on the curve that begins at vertex @p piece, @p along [m] of its parameter beyond it, which
  /// runs up to length(piece).
  Place at(unsigned int piece, double along) const;

  /// The place of vertex @p m, where piece m begins.
  const Place &at_vertex(const unsigned int m) const { return places[m]; }

  /// Number of pieces, which is that of the vertices.
  unsigned int n_pieces() const { return vertex.size(); }
  /// Length of the chord from vertex @p piece to the next [m].
  double length(const unsigned int piece) const { return chord[piece]; }

  Place move(const Place &place, const dealii::Tensor<1, 1> &way) const override;

  /// The vertex at which the piece of @p place begins, or at whose end it stands, as the other piece has it.
  Place beyond_edge(const Place &place) const override
  {
    const unsigned int before = previous[place.piece];
    return place.along > 0. ? at(next[place.piece], 0.) : at(before, chord[before]);
  }

private:
  void lay_spline(const std::vector<unsigned int> &piece, bool closed);

  std::vector<dealii::Point<2>> vertex;
  std::vector<char> corner;
  std::vector<unsigned int> next, previous; ///< in the loop
  std::vector<double> chord;                ///< length, of every piece [m]
  /// Changes of position per parameter at both ends of every piece.
  std::vector<Vector> begins, ends;
  std::vector<Place> places; ///< at vertices
};
} // namespace softgrain

#endif
