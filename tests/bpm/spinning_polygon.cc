// SPDX-License-Identifier: LGPL-2.1-or-later
// A square given by its corners, far from the origin, turns about its own centre: the centre of its mass
// hardly moves, and the angular momentum about it is that of a square, mass times edge^2 / 6 times the
// angular velocity.
#include "bpm_scene.h"

#include <iostream>

using namespace softgrain;

int main()
{
  const auto model = bpm_scene(grain_scene(R"(
subsection Bodies
  set Names = square
  subsection square
    set Shape = polygon
    set Vertices = 490, 290; 510, 290; 510, 310; 490, 310
    set Angular velocity = 0.1
  end
end
)"));
  const Snapshot<2> start = model->snapshot();
  const BodyState<2> &body = start.bodies[0];
  double weight = 0., moment = 0.; // masses of primaries go with their areas
  for (std::size_t p = 0; p < start.points.position.size(); ++p)
  {
    const double area = start.points.size[p];
    weight += area;
    moment += area * start.points.position[p].distance_square(body.center);
  }
  std::cout << "velocity over that of a corner "
            << below(0.02, body.velocity.norm() / (0.1 * std::sqrt(200.)))
            << ", angular momentum over angular velocity times moment of inertia "
            << body.angular_momentum / (0.1 * body.mass * moment / weight) << '\n';
}
