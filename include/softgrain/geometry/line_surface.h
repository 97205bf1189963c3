// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_line_surface_h
#define softgrain_geometry_line_surface_h

#include <softgrain/geometry/curve.h>
#include <softgrain/geometry/rest_surface.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Both sides of a line of finite length, as one closed surface around a solid without thickness.
 *
 * Piece k < n is the right side of piece k of the line, on which one goes from its beginning to its end;
 * piece n + k is its left side, on which one goes back. So the solid is to the left of the way, as it is for
 * outlines. The surface has corners where the line ends and where its pieces meet at an angle.
 */
class LineSurface : public RestSurface<2>
{
public:
  using Place = SurfacePlace<2>;

  /// @param pieces of the line, each of which begins where the one before it ends
  /// @param tip    whether the line has an end or a corner where a piece begins, and, one more, at its end
  LineSurface(std::vector<Curve> pieces, std::vector<char> tip);

  unsigned int n_pieces() const { return 2 * pieces.size(); }
  double length(const unsigned int piece) const { return pieces[piece % pieces.size()].length(); } ///< [m]

  /// The place @p along [m] from where one comes to a piece.
  Place at(unsigned int piece, double along) const;

  Place move(const Place &place, const dealii::Tensor<1, 1> &way) const override;
  Place beyond_edge(const Place &place) const override
  {
    return at(previous(place.piece), length(previous(place.piece)));
  }

  /// Whether there is a corner where one comes to a piece.
  bool corner_before(unsigned int piece) const;
  /// The piece from which one comes to @p piece.
  unsigned int previous(unsigned int piece) const;

private:
  unsigned int next(unsigned int piece) const;

  std::vector<Curve> pieces;
  std::vector<char> tip;
  bool loop; ///< the line ends where it begins
};
} // namespace softgrain

#endif
