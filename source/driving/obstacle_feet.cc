// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/obstacle_feet.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
/// Ends of two lines that are nearer than this share of their extents are in one place.
constexpr double same_place = 1e-9;

/// Turn of an arc from one vertex to the next, for circles around it [rad].
constexpr double turn = 0.5;
} // namespace

ObstacleFeet::ObstacleFeet(const std::vector<Obstacle<2>> &list) : obstacles(list)
{
  for (std::size_t o = 0; o < obstacles.size(); ++o)
  {
    std::vector<Polygon> lines;
    piece_circles.emplace_back();
    for (const Curve &piece : pieces(o))
    {
      lines.push_back(piece.line(turn));
      piece_circles.back().push_back(circle_around({lines.back()}));
    }
    circles.push_back(circle_around(lines));
  }
}

ObstacleFeet::Circle ObstacleFeet::circle_around(const std::vector<Polygon> &lines)
{
  dealii::Point<2> lower = lines.front().front(), upper = lower;
  for (const Polygon &line : lines)
    for (const dealii::Point<2> &vertex : line)
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], vertex[d]);
        upper[d] = std::max(upper[d], vertex[d]);
      }
  Circle circle{lower + 0.5 * (upper - lower), 0.};
  // An arc of less than half a turn stays in the circle that has its chord as diameter.
  for (const Polygon &line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const dealii::Tensor<1, 2> half = 0.5 * (line[i + 1] - line[i]);
      circle.radius = std::max(circle.radius, circle.center.distance(line[i] + half) + half.norm());
    }
  return circle;
}

dealii::Point<2> ObstacleFeet::place(const End &end) const
{
  const Curve &piece = pieces(end.obstacle)[end.piece];
  return end.last ? piece.end() : piece.begin();
}

bool ObstacleFeet::is_loop(const std::size_t o) const
{
  return pieces(o).size() > 1 && pieces(o).back().end() == pieces(o).front().begin();
}

ObstacleFeet::Joints ObstacleFeet::join() const
{
  Joints joints(obstacles.size());
  std::vector<End> free;
  for (std::uint32_t o = 0; o < obstacles.size(); ++o)
    if (!is_loop(o) && !pieces(o).front().closed())
      for (const End &end :
           {End{o, 0, false}, End{o, static_cast<std::uint32_t>(pieces(o).size() - 1), true}})
        free.push_back(end);
  const auto joint = [&joints](const End &end) -> std::optional<End> &
  { return joints[end.obstacle][end.last]; };
  for (std::size_t i = 0; i < free.size(); ++i)
    for (std::size_t j = i + 1; j < free.size(); ++j)
    {
      const End &a = free[i], &b = free[j];
      if (a.obstacle == b.obstacle || joint(a) || joint(b))
        continue;
      const double apart =
          obstacles[a.obstacle].now.placed(place(a)).distance(obstacles[b.obstacle].now.placed(place(b)));
      if (apart > same_place * (circles[a.obstacle].radius + circles[b.obstacle].radius))
        continue;
      joint(a) = b;
      joint(b) = a;
    }
  return joints;
}

std::optional<ObstacleFeet::End> ObstacleFeet::next(const End &end, const Joints &joints) const
{
  const std::uint32_t o = end.obstacle, last_piece = pieces(o).size() - 1;
  if (end.last && end.piece < last_piece)
    return End{o, end.piece + 1, false};
  if (!end.last && end.piece > 0)
    return End{o, end.piece - 1, true};
  if (is_loop(o))
    return End{o, end.last ? 0 : last_piece, !end.last};
  return joints[o][end.last];
}

bool ObstacleFeet::is_touched(const End &end, const dealii::Point<2> &center, const Joints &joints) const
{
  const std::optional<End> other = next(end, joints);
  if (!other)
    return true;
  const Curve &piece = pieces(other->obstacle)[other->piece];
  if (piece.foot(obstacles[other->obstacle].now.drawn(center)).place != place(*other))
    return false;
  // Both pieces end in a corner that stands out: it is touched once.
  return end < *other;
}

double ObstacleFeet::farthest_way(const std::size_t o) const
{
  const ObstacleMotion<2> &way = obstacles[o].way;
  return way.start.placed(circles[o].center).distance(way.end.placed(circles[o].center)) +
         std::abs(way.end.angle - way.start.angle) * circles[o].radius;
}

double ObstacleFeet::distance(const std::size_t o, const dealii::Point<2> &drawn, const double far) const
{
  double nearest = std::numeric_limits<double>::max();
  if (drawn.distance(circles[o].center) > circles[o].radius + far)
    return nearest;
  for (std::size_t k = 0; k < pieces(o).size(); ++k)
    if (drawn.distance(piece_circles[o][k].center) <= piece_circles[o][k].radius + far)
      nearest = std::min(nearest, drawn.distance(pieces(o)[k].foot(drawn).place));
  return nearest;
}

std::vector<ObstacleFeet::Foot> ObstacleFeet::find(const std::vector<std::array<double, 2>> &centers,
                                                   const std::vector<double> &radii,
                                                   const double reach) const
{
  const Joints joints = join();
  std::vector<Foot> feet;
  for (std::uint32_t o = 0; o < obstacles.size(); ++o)
  {
    const Pose<2> &now = obstacles[o].now;
    const dealii::Point<2> middle = now.placed(circles[o].center);
    const std::size_t first = feet.size();
    for (std::uint32_t i = 0; i < centers.size(); ++i)
    {
      const dealii::Point<2> center(centers[i][0], centers[i][1]);
      const double far = radii[i] + reach;
      if (center.distance(middle) > circles[o].radius + far)
        continue;
      const dealii::Point<2> drawn = now.drawn(center);
      for (std::uint32_t k = 0; k < pieces(o).size(); ++k)
      {
        if (drawn.distance(piece_circles[o][k].center) > piece_circles[o][k].radius + far)
          continue;
        const dealii::Point<2> touched = pieces(o)[k].foot(drawn).place;
        const dealii::Tensor<1, 2> arm = center - now.placed(touched);
        const double distance = arm.norm();
        if (distance > far)
          continue;
        if (!pieces(o)[k].closed() &&
            ((touched == pieces(o)[k].begin() && !is_touched({o, k, false}, center, joints)) ||
             (touched == pieces(o)[k].end() && !is_touched({o, k, true}, center, joints))))
          continue;
        // A centre on the line has no side; any one gets it away.
        feet.push_back({o, k, i, touched, distance > 0. ? arm / distance : dealii::Tensor<1, 2>({0., 1.}),
                        distance - radii[i]});
      }
    }
    std::stable_sort(feet.begin() + first, feet.end(),
                     [](const Foot &a, const Foot &b) { return a.piece < b.piece; });
  }
  return feet;
}
} // namespace softgrain
