// SPDX-License-Identifier: LGPL-2.1-or-later
// Both sides of a line as one closed surface: one comes round to where one began, tangents and bends are the
// derivatives of places, normals stand out of the line on either side, and a walk stops at ends and corners
// but not where pieces go on smoothly.
#include <softgrain/geometry/line_surface.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace softgrain;

namespace
{
using Vector = dealii::Tensor<1, 2>;
const double pi = std::acos(-1.);

/// By how much tangents and bends miss the differences of places beside them, over all pieces.
double wrong_derivatives(const LineSurface &surface)
{
  double worst = 0.;
  const double step = 1e-4;
  for (unsigned int piece = 0; piece < surface.n_pieces(); ++piece)
    for (const double share : {0.2, 0.5, 0.8})
    {
      const double along = share * surface.length(piece);
      const auto here = surface.at(piece, along), after = surface.at(piece, along + step),
                 before = surface.at(piece, along - step);
      const Vector slope = (after.position - before.position) / (2. * step),
                   second =
                       ((after.position - here.position) - (here.position - before.position)) / (step * step);
      worst = std::max({worst, (slope - here.tangent[0]).norm(),
                        (second + here.bend[0][0] * here.normal).norm() * 1e-2,
                        std::abs(here.tangent[0] * here.normal)});
    }
  return worst;
}

/// A way along all of it, piece by piece: the largest hole between one and the next.
double holes(const LineSurface &surface)
{
  double worst = 0.;
  for (unsigned int piece = 0; piece < surface.n_pieces(); ++piece)
  {
    const unsigned int last = surface.previous(piece);
    worst = std::max(
        worst, surface.at(piece, 0.).position.distance(surface.at(last, surface.length(last)).position));
  }
  return worst;
}

void walk(const std::string &name, const LineSurface &surface, const unsigned int piece, const double way)
{
  dealii::Tensor<1, 1> by;
  by[0] = way;
  const auto end = surface.move(surface.at(piece, 0.5 * surface.length(piece)), by);
  std::cout << name << " from piece " << piece << " by " << way << " : piece " << end.piece << " at "
            << end.position << (end.at_edge ? " , at an edge\n" : "\n");
}
} // namespace

int main()
{
  // A straight piece that goes on into an arc, and one at a right angle to that.
  const LineSurface line({Curve::segment({-2., 0.}, {0., 0.}), Curve::arc({0., 1.}, 1., -pi / 2., 0.),
                          Curve::segment({1., 1.}, {3., 1.})},
                         {1, 0, 1, 1}),
      circle({Curve::arc({0., 0.}, 2., 0., 2. * pi)}, {0, 0});
  for (const LineSurface *surface : {&line, &circle})
    std::cout << (wrong_derivatives(*surface) < 1e-7 ? "derivatives" : "WRONG DERIVATIVES") << ", "
              << (holes(*surface) < 1e-15 ? "closed" : "WITH HOLES") << '\n';
  std::cout << "normals of both sides " << line.at(0, 1.).normal << " and " << line.at(5, 1.).normal << '\n';
  std::cout << "bends " << line.at(1, 0.5).bend[0][0] << " and " << line.at(4, 0.5).bend[0][0] << '\n';
  for (const double way : {0.5, 1.5, 5., -5.})
    walk("line", line, 0, way);
  walk("line", line, 4, 1.5);
  walk("line", line, 2, -5.);
  walk("circle", circle, 0, 6. * pi);
  walk("circle", circle, 1, -3. * pi);
}
