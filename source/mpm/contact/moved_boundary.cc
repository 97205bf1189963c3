// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/at_marker.h>
#include <softgrain/mpm/contact/moved_boundary.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Point = MovedBoundary::Point;
using Vector = MovedBoundary::Vector;

} // namespace

template <int dim>
double largest_way(const Body<dim> &body, const Eigen::VectorXd &displacement)
{
  double way = 0.;
  for (unsigned int m = 0; m < body.boundary.position.size(); m += body.boundary.stride)
    way = std::max(way, at_marker(body, m, displacement).norm());
  return way;
}

template double largest_way(const Body<2> &, const Eigen::VectorXd &);
template double largest_way(const Body<3> &, const Eigen::VectorXd &);

MovedBoundary::MovedBoundary(const Body<2> &body, const OutlineScene &scene)
    : body(&body)
    , lower(std::numeric_limits<double>::max(), std::numeric_limits<double>::max())
    , upper(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest())
{
  find_center(scene);
  find_displacements(scene);
  move_markers(scene);
  for (unsigned int m = 0; m < position.size(); ++m)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], position[m][d]);
      upper[d] = std::max(upper[d], position[m][d]);
    }
    // Not of the nodes: those on the rim may be fast and move nothing.
    if (m % body.boundary.stride == 0)
      spread = std::max(spread, (displacement[m] - travel).norm());
  }
}

MovedBoundary::Sketch MovedBoundary::sketch() const
{
  return {{center[0], center[1], start[0], start[1], travel[0], travel[1], spread, lower[0], lower[1],
           upper[0], upper[1]}};
}

MovedBoundary::MovedBoundary(const Body<2> &body, const Sketch &sketch)
    : center(sketch[0], sketch[1])
    , start(sketch[2], sketch[3])
    , travel({sketch[4], sketch[5]})
    , spread(sketch[6])
    , body(&body)
    , lower(sketch[7], sketch[8])
    , upper(sketch[9], sketch[10])
{
}

void MovedBoundary::take_markers(const OutlineScene &scene, const double *const displacements)
{
  displacement.resize(body->boundary.position.size());
  std::copy_n(displacements, 2 * displacement.size(), displacement[0].begin_raw());
  move_markers(scene);
}

void MovedBoundary::find_displacements(const OutlineScene &scene)
{
  const Vector taken = scene.cell != nullptr ? scene.dt * scene.cell->velocity(start) : Vector();
  displacement.reserve(body->boundary.position.size());
  for (unsigned int m = 0; m < body->boundary.position.size(); ++m)
  {
    Vector moved = body->rigid.driven ? scene.dt * scene.drive[body->index]
                                      : at_marker(*body, m, scene.increment[body->index]);
    if (scene.cell != nullptr)
      moved += taken;
    displacement.push_back(moved);
  }
}

void MovedBoundary::move_markers(const OutlineScene &scene)
{
  position = body->boundary.position;
  const Point start_center = center - scene.share * travel;
  double along = 0., across = 0.;
  for (unsigned int m = 0; m < position.size(); ++m)
  {
    const Vector &moved = displacement[m];
    const Vector arm = position[m] - start_center, after = arm + moved - travel;
    along += arm * after;
    across += arm[0] * after[1] - arm[1] * after[0];
    position[m] += scene.share * moved;
  }
  const double length = std::hypot(along, across);
  if (!body->rigid.driven && length != 0. && scene.share != 0. && scene.share != 1.)
  {
    // Chords cut the corners of circles: drawn along them, a body that turns is smaller on its way.
    const double grow = 1. / std::sqrt(1. - 2. * scene.share * (1. - scene.share) * (1. - along / length));
    for (Point &x : position)
      x = center + grow * (x - center);
  }
}

void MovedBoundary::find_center(const OutlineScene &scene)
{
  if (body->rigid.driven)
  {
    travel = scene.dt * scene.drive[body->index];
    return; // nobody asks where the centre of such a body is
  }
  Vector moment, way;
  for (unsigned int i = 0; i < body->nodes.mass.size(); ++i)
  {
    const Point &at = body->field.place(i);
    for (unsigned int d = 0; d < 2; ++d)
    {
      moment[d] += body->nodes.mass[i] * (at[d] + body->nodes.displacement[2 * i + d]);
      way[d] += body->nodes.mass[i] * scene.increment[body->index][2 * i + d];
    }
  }
  const double mass = body->nodes.mass.sum();
  travel = way / mass;
  if (scene.cell != nullptr)
  {
    start = Point(moment / mass);
    travel += scene.dt * scene.cell->velocity(start);
  }
  center = Point(moment / mass + scene.share * travel);
}

void MovedBoundary::shift(const Vector &way, const Vector &moves, const double share)
{
  const Vector here = way + share * moves;
  for (Point &x : position)
    x += here;
  for (Vector &u : displacement)
    u += moves;
  for (Point *x : {&lower, &upper, &center})
    *x += here;
  start += way;
  travel += moves;
}
} // namespace softgrain::mpm
