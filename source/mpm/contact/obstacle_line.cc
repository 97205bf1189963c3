// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/obstacle_line.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// Gives a sample where @p piece begins in a corner the normal and the angle of the corner.
void make_corner(const LineSurface &surface,
                 const unsigned int piece,
                 const Pose &pose,
                 SampledSurface<2>::Sample &sample)
{
  const unsigned int last = surface.previous(piece);
  const Vector before = surface.at(last, surface.length(last)).tangent[0],
               after = surface.at(piece, 0.).tangent[0];
  const double turn = before[0] * after[1] - before[1] * after[0], cosine = before * after;
  // At an end of the line it turns back.
  const bool turns_back = cosine < -1. + 1e-12;
  Vector normal = turns_back ? before : Vector({before[1] + after[1], -before[0] - after[0]});
  sample.normal = pose.turned(normal / normal.norm(), pose.angle);
  // What is a dent has no cone of normals.
  if (turn > 0. || turns_back)
    sample.corner = 0.5 * std::acos(std::clamp(cosine, -1., 1.));
}
} // namespace

LineSurface surface_of(const Obstacle &obstacle)
{
  std::vector<char> tips;
  for (std::size_t k = 0; k <= obstacle.description.pieces.size(); ++k)
    tips.push_back(obstacle.has_tip(k));
  return {obstacle.description.pieces, std::move(tips)};
}

ObstacleLine::ObstacleLine(const Obstacle &obstacle)
    : friction(obstacle.description.friction), surface(surface_of(obstacle)), way(obstacle.way)
{
}

double ObstacleLine::largest_way() const
{
  double largest = 0.;
  for (unsigned int piece = 0; piece < surface.n_pieces() / 2; ++piece)
    for (const double share : {0., 0.25, 0.5, 0.75, 1.})
      largest = std::max(largest, way_of(surface.at(piece, share * surface.length(piece))).norm());
  return largest;
}

SampledSurface<2> ObstacleLine::samples(const double spacing) const
{
  SampledSurface<2> result;
  result.spacing = spacing;
  const Pose &pose = way.start;
  const unsigned int n = surface.n_pieces() / 2;
  std::vector<unsigned int> first(2 * n), last(2 * n); // samples of every piece
  for (unsigned int step = 0; step < 2 * n; ++step)
  {
    // On along the right side and back along the left one.
    const unsigned int piece = step < n ? step : 3 * n - 1 - step;
    const double length = surface.length(piece);
    const unsigned int parts = std::max(1., std::ceil(length / spacing));
    first[piece] = result.samples.size();
    last[piece] = first[piece] + parts - 1;
    for (unsigned int i = 0; i < parts; ++i)
    {
      SampledSurface<2>::Sample sample;
      sample.place = surface.at(piece, i * length / parts);
      sample.position = pose.placed(sample.place.position);
      sample.normal = pose.turned(sample.place.normal, pose.angle);
      if (i == 0 && surface.corner_before(piece))
        make_corner(surface, piece, pose, sample);
      else if (i > 0)
        result.neighbours.emplace_back(first[piece] + i - 1, first[piece] + i);
      result.samples.push_back(sample);
    }
  }
  for (unsigned int piece = 0; piece < 2 * n; ++piece)
    result.neighbours.emplace_back(last[surface.previous(piece)], first[piece]);
  return result;
}

RaySide<2> ObstacleLine::meet(const Ray<2> &ray, const double share, const SurfacePlace<2> &guess) const
{
  const Pose pose = way.at(share);
  const auto turn = [&](const Vector &v, const double by) { return pose.turned(v, by); };
  Ray<2> drawn = ray;
  drawn.origin = pose.drawn(ray.origin);
  drawn.direction = turn(ray.direction, -pose.angle);
  drawn.across[0] = turn(ray.across[0], -pose.angle);
  RaySide<2> side = mpm::meet(drawn, surface, guess);
  side.normal = turn(side.normal, pose.angle);
  side.way[0] = turn(side.way[0], pose.angle);
  // A rigid surface bends along its tangent alone.
  const double bend = trace(side.sliding_twice), length = side.way[0].norm_square();
  side.sliding_twice =
      length > 0. ? bend / length * outer_product(side.way[0], side.way[0]) : dealii::Tensor<2, 2>();
  return side;
}
} // namespace softgrain::mpm
