// SPDX-License-Identifier: LGPL-2.1-or-later
// Segments and arcs: the nearest place of a curve is nearer than all others on it, its normal points to the
// left, and what lies beyond an end is told from what lies beside it.
#include <softgrain/geometry/curve.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
const double pi = std::acos(-1.);

/// How much nearer than its foot a place of the curve is; sampled.
double nearer_than_foot(const Curve &curve)
{
  double worst = 0.;
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j)
    {
      const dealii::Point<2> p(0.11 * i, 0.13 * j);
      const double distance = p.distance(curve.foot(p).place);
      for (const dealii::Point<2> &x : curve.line(0.01))
        worst = std::max(worst, distance - p.distance(x));
    }
  return worst;
}

void look(const std::string &name, const Curve &curve, const dealii::Point<2> &p)
{
  const Curve::Foot foot = curve.foot(p);
  std::cout << name << " from " << p << " : " << foot.place << " , normal " << foot.normal << " , beyond "
            << foot.beyond << '\n';
}
} // namespace

int main()
{
  const Curve segment = Curve::segment({-1., 0.}, {1., 0.5}), flat = Curve::segment({0., 0.}, {2., 0.}),
              half = Curve::arc({0., 0.}, 1., pi, 2. * pi),
              late = Curve::arc({0.5, 0.}, 1., 1.5 * pi, 2.5 * pi),
              circle = Curve::arc({0., 0.}, 2., 0., 2. * pi);
  for (const Curve &curve : {segment, flat, half, late, circle})
    std::cout << (nearer_than_foot(curve) < 1e-12 ? "nearest" : "NOT NEAREST") << ", "
              << (curve.closed() ? "closed" : "with ends") << '\n';
  look("flat", flat, {0.5, 1.});
  look("flat", flat, {0.5, -1.});
  look("flat", flat, {-0.25, 1.});
  look("flat", flat, {2.5, 0.});
  look("half", half, {0., -0.5});
  look("half", half, {0., -2.});
  look("half", half, {0.8, 0.6});
  look("half", half, {-0.8, 0.6});
  look("late", late, {3.5, 0.});
  look("circle", circle, {0., 1.});
  std::cout << "ends of the half " << half.begin() << " and " << half.end() << " , directions "
            << half.direction_at_begin() << " and " << half.direction_at_end() << '\n';
}
