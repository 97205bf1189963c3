// SPDX-License-Identifier: LGPL-2.1-or-later
// Random packings in space: no ball in another or outside of the box, the same for the same seed and another
// for another, as dense as asked for; what cannot be packed is refused; tables come back as they were
// written.
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

using namespace softgrain;

namespace
{
PackingRequest3D request_of(const unsigned int number, const double fraction)
{
  PackingRequest3D request;
  request.number = number;
  request.sizes.smallest = 0.9;
  request.sizes.largest = 1.2;
  request.fraction = fraction;
  request.lower = dealii::Point<3>(-3., 5., 0.5);
  request.upper = request.lower + dealii::Point<3>(9., 6., 5.);
  return request;
}

bool same(const Packing<3> &a, const Packing<3> &b)
{
  return std::equal(a.balls.begin(), a.balls.end(), b.balls.begin(), b.balls.end(),
                    [](const Packing<3>::Ball &one, const Packing<3>::Ball &other)
                    { return one.center == other.center && one.radius == other.radius; });
}

void look(const unsigned int number, const double fraction)
{
  PackingRequest3D request = request_of(number, fraction);
  const Packing<3> packing = make_packing(request), again = make_packing(request);
  request.seed = 2;
  const Packing<3> other = make_packing(request);
  double overlap = 0., outside = 0., mean = 0.;
  unsigned int touching = 0;
  for (const Packing<3>::Ball &ball : packing.balls)
    mean += ball.radius / number;
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
  {
    const Packing<3>::Ball &ball = packing.balls[i];
    for (unsigned int d = 0; d < 3; ++d)
      outside = std::max({outside, request.lower[d] + ball.radius - ball.center[d],
                          ball.center[d] + ball.radius - request.upper[d]});
    for (std::size_t j = 0; j < i; ++j)
    {
      const double gap =
          ball.center.distance(packing.balls[j].center) - ball.radius - packing.balls[j].radius;
      overlap = std::max(overlap, -gap);
      touching += gap < 0.02 * mean ? 2 : 0;
    }
  }
  const double reached = solid_volume(packing) / (9. * 6. * 5.);
  std::cout << packing.balls.size() << " balls at " << fraction << ": overlap "
            << (overlap < 1e-12 ? 0. : overlap) << ", outside " << (outside < 1e-12 ? 0. : outside)
            << (same(packing, again) ? ", repeatable" : ", NOT REPEATABLE")
            << (same(packing, other) ? ", SEED WITHOUT EFFECT" : "") << ", fraction "
            << (std::abs(reached - fraction) < 1e-9 ? "as asked for" : "WRONG") << ", touching per ball "
            << (touching > 2 * number ? "above" : "below") << " 2\n";
}

template <typename F>
void refused(const F &work)
{
  try
  {
    work();
    std::cout << "NOT REFUSED\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  look(27, 0.2);
  look(27, 0.4);
  look(200, 0.55);
  look(120, 0.56);
  refused([] { make_packing(request_of(20, 0.7)); });
  refused([] { make_packing(request_of(60, 0.8)); });
  refused(
      []
      {
        PackingRequest3D request = request_of(2, 0.);
        request.sizes.smallest = request.sizes.largest = 4.9;
        request.upper[0] = request.lower[0] + 5.;
        make_packing(request);
      });

  Packing<3> packing;
  packing.balls = {{dealii::Point<3>(0.1, -2e-7, 1. / 7.), 1. / 3.}, {dealii::Point<3>(1e10, 0., 4.), 2.}};
  write_packing("balls.csv", packing);
  std::cout << (same(read_packing<3>("balls.csv"), packing) && holds_packing("balls.csv", packing)
                    ? "read as written"
                    : "NOT AS WRITTEN")
            << '\n';
  packing.materials = {"soft rubber", "gel"};
  write_packing("materials.csv", packing);
  const Packing<3> mixed = read_packing<3>("materials.csv");
  std::cout << mixed.balls.size() << " balls of " << mixed.materials[0] << " and " << mixed.materials[1]
            << '\n';
  std::ofstream("plane.csv") << "x_m,y_m,radius_m\n0,0,1\n";
  refused([] { read_packing<3>("plane.csv"); });
  std::ofstream("bad.csv") << "x_m,y_m,z_m,radius_m\n0,0,0,1\n0,1,1,0\n";
  refused([] { read_packing<3>("bad.csv"); });
}
