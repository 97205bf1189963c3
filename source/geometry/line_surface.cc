// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/line_surface.h>

#include <algorithm>
#include <utility>

namespace softgrain
{
LineSurface::LineSurface(std::vector<Curve> pieces_of_line, std::vector<char> tips)
    : pieces(std::move(pieces_of_line))
    , tip(std::move(tips))
    , loop(pieces.front().closed() || pieces.back().end() == pieces.front().begin())
{
  // Of a loop the end is where it begins.
  if (loop)
    tip.back() = tip.front();
}

LineSurface::Place LineSurface::at(const unsigned int piece, const double along) const
{
  const unsigned int n = pieces.size();
  const bool back = piece >= n;
  const Curve &curve = pieces[piece % n];
  const double length = curve.length(), here = std::clamp(along, 0., length);
  const Curve::Course course = curve.course(back ? length - here : here);
  Place place;
  place.position = course.place;
  place.tangent[0] = back ? -course.direction : course.direction;
  place.normal = Curve::Vector({place.tangent[0][1], -place.tangent[0][0]});
  place.bend[0][0] = back ? -course.bend : course.bend;
  place.piece = piece;
  place.along = here;
  place.at_edge = (here == 0. && corner_before(piece)) || (here == length && corner_before(next(piece)));
  return place;
}

unsigned int LineSurface::next(const unsigned int piece) const
{
  const unsigned int n = pieces.size();
  if (piece < n)
    return piece + 1 < n ? piece + 1 : loop ? 0 : 2 * n - 1;
  return piece > n ? piece - 1 : loop ? 2 * n - 1 : 0;
}

unsigned int LineSurface::previous(const unsigned int piece) const
{
  const unsigned int n = pieces.size();
  if (piece < n)
    return piece > 0 ? piece - 1 : loop ? n - 1 : n;
  return piece + 1 < 2 * n ? piece + 1 : loop ? n : n - 1;
}

bool LineSurface::corner_before(const unsigned int piece) const
{
  // On the way back one comes to the end of a piece.
  const unsigned int n = pieces.size();
  return tip[piece < n ? piece : piece - n + 1];
}

LineSurface::Place LineSurface::move(const Place &place, const dealii::Tensor<1, 1> &way) const
{
  unsigned int piece = place.piece;
  double along = place.along + way[0];
  for (unsigned int passed = 0; passed < n_pieces(); ++passed)
    if (along > length(piece) && !corner_before(next(piece)))
    {
      along -= length(piece);
      piece = next(piece);
    }
    else if (along < 0. && !corner_before(piece))
    {
      piece = previous(piece);
      along += length(piece);
    }
    else
      break;
  return at(piece, along);
}
} // namespace softgrain
