// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/outline_surface.h>

#include <Eigen/SparseLU>

#include <utility>

namespace softgrain
{
OutlineSurface::OutlineSurface(std::vector<dealii::Point<2>> vertices,
                               const std::vector<unsigned int> &loop_start,
                               std::vector<char> corners)
    : vertex(std::move(vertices))
    , corner(std::move(corners))
    , next(vertex.size())
    , previous(vertex.size())
    , begins(vertex.size())
    , ends(vertex.size())
{
  for (unsigned int l = 0; l + 1 < loop_start.size(); ++l)
    for (unsigned int m = loop_start[l]; m < loop_start[l + 1]; ++m)
    {
      next[m] = m + 1 == loop_start[l + 1] ? loop_start[l] : m + 1;
      previous[next[m]] = m;
    }
  for (unsigned int m = 0; m < vertex.size(); ++m)
    chord.push_back(vertex[m].distance(vertex[next[m]]));
  for (unsigned int l = 0; l + 1 < loop_start.size(); ++l)
  {
    unsigned int first = loop_start[l];
    while (first < loop_start[l + 1] && !corner[first])
      ++first;
    const bool closed = first == loop_start[l + 1];
    if (closed)
      first = loop_start[l];
    // From corner to corner, or around.
    std::vector<unsigned int> pieces;
    unsigned int m = first;
    do
    {
      pieces.push_back(m);
      m = next[m];
      if ((!closed && corner[m]) || m == first)
      {
        lay_spline(pieces, closed);
        pieces.clear();
      }
    } while (m != first);
  }
  for (unsigned int m = 0; m < vertex.size(); ++m)
    places.push_back(at(m, 0.));
}

void OutlineSurface::lay_spline(const std::vector<unsigned int> &piece, const bool closed)
{
  // Unknowns are the changes of position per parameter at the ends of pieces; where two pieces meet, second
  // changes agree, and at a corner they are none.
  const unsigned int n_pieces = piece.size(), n = closed ? n_pieces : n_pieces + 1;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 2);
  const auto add_piece = [&](const unsigned int row, const unsigned int p, const bool begins_there)
  {
    const unsigned int m = piece[p], begin = p, end = (p + 1) % n;
    entries.emplace_back(row, begins_there ? begin : end, 2. / chord[m]);
    entries.emplace_back(row, begins_there ? end : begin, 1. / chord[m]);
    const Vector change = 3. / (chord[m] * chord[m]) * (vertex[next[m]] - vertex[m]);
    right(row, 0) += change[0];
    right(row, 1) += change[1];
  };
  for (unsigned int i = 0; i < n; ++i)
  {
    if (closed || i < n_pieces)
      add_piece(i, i, true);
    if (closed || i > 0)
      add_piece(i, (i + n_pieces - 1) % n_pieces, false);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(matrix);
  const Eigen::MatrixXd slope = factor.solve(right);
  for (unsigned int p = 0; p < n_pieces; ++p)
    for (unsigned int d = 0; d < 2; ++d)
    {
      begins[piece[p]][d] = slope(p, d);
      ends[piece[p]][d] = slope((p + 1) % n, d);
    }
}

OutlineSurface::Place OutlineSurface::at(const unsigned int piece, const double along) const
{
  const double l = chord[piece], t = along / l;
  const Vector way = vertex[next[piece]] - vertex[piece], &begin = begins[piece], &end = ends[piece];
  Place place;
  place.position =
      vertex[piece] + t * t * (3. - 2. * t) * way + l * t * (1. - t) * ((1. - t) * begin - t * end);
  const Vector change =
      6. * t * (1. - t) / l * way + (1. - t) * (1. - 3. * t) * begin - t * (2. - 3. * t) * end;
  const Vector second = (6. - 12. * t) / (l * l) * way + ((6. * t - 4.) * begin + (6. * t - 2.) * end) / l;
  const double speed = change.norm();
  place.tangent[0] = change / speed;
  place.normal = Vector({place.tangent[0][1], -place.tangent[0][0]});
  place.bend[0][0] = -(second * place.normal) / (speed * speed);
  place.piece = piece;
  place.along = along;
  place.at_edge = (along <= 0. && corner[piece]) || (along >= l && corner[next[piece]]);
  return place;
}

OutlineSurface::Place OutlineSurface::move(const Place &place, const dealii::Tensor<1, 1> &way) const
{
  unsigned int piece = place.piece;
  // The parameter is the length of the chord: nearly that of the curve.
  double along = place.along + way[0];
  while (along < 0. && !corner[piece])
  {
    piece = previous[piece];
    along += chord[piece];
  }
  while (along > chord[piece] && !corner[next[piece]])
  {
    along -= chord[piece];
    piece = next[piece];
  }
  return at(piece, std::min(std::max(along, 0.), chord[piece]));
}
} // namespace softgrain
