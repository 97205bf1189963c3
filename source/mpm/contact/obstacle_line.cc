// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_stretches.h>
#include <softgrain/mpm/contact/obstacle_line.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// The turn where one comes to a piece.
struct Turn
{
  Turn(const LineSurface &surface, const unsigned int piece)
      : last(surface.previous(piece))
      , before(surface.at(last, surface.length(last)).tangent[0])
      , after(surface.at(piece, 0.).tangent[0])
  {
  }
  double cosine() const { return before * after; }
  /// At an end of the line it turns back.
  bool turns_back() const { return cosine() < -1. + 1e-12; }
  /// What is a dent has no cone of normals: there are those of both sides alone.
  bool is_dent() const { return !turns_back() && before[0] * after[1] - before[1] * after[0] < 0.; }

  const unsigned int last; ///< piece
  const Vector before, after;
};

/// Gives a sample where a piece begins in a corner the normal and the angle of the corner.
void make_corner(const Turn &turn, const Pose<2> &pose, SampledSurface<2>::Sample &sample)
{
  const Vector normal = turn.turns_back()
                            ? turn.before
                            : Vector({turn.before[1] + turn.after[1], -turn.before[0] - turn.after[0]});
  sample.normal = pose.turned(normal / normal.norm(), pose.angle);
  sample.corner = 0.5 * std::acos(std::clamp(turn.cosine(), -1., 1.));
}

SampledSurface<2>::Sample sample_of(const SurfacePlace<2> &place, const Pose<2> &pose)
{
  SampledSurface<2>::Sample sample;
  sample.place = place;
  sample.position = pose.placed(place.position);
  sample.normal = pose.turned(place.normal, pose.angle);
  return sample;
}

/// Where a line goes straight on, up to about a degree, there is no corner.
constexpr double straight_on = 0.9998;

/// Whether @p second goes straight on where @p first ends, to rounding.
bool goes_straight_on(const Curve &first, const Curve &second)
{
  constexpr double rounding = 1e-10;
  if (first.course(0.).bend != 0. || second.course(0.).bend != 0.)
    return false;
  const Vector before = first.direction_at_end(), after = second.direction_at_begin();
  return before * after > 0. && std::abs(before[0] * after[1] - before[1] * after[0]) < rounding;
}

/// Straight pieces that go on straight are one: rays then stand where they do on a line of one piece.
std::vector<Curve> without_joints(const std::vector<Curve> &pieces)
{
  std::vector<Curve> joined;
  for (const Curve &piece : pieces)
    if (!joined.empty() && goes_straight_on(joined.back(), piece))
      joined.back() = Curve::segment(joined.back().begin(), piece.end());
    else
      joined.push_back(piece);
  return joined;
}

/// Whether piece @p k begins in a corner, or in an end of the line: what can be touched by itself. @param k
/// may be the number of pieces: the end of the last one
bool has_tip(const std::vector<Curve> &pieces, const std::size_t k)
{
  if (pieces.front().closed())
    return false;
  const bool loop = pieces.size() > 1 && pieces.back().end() == pieces.front().begin();
  if (k == pieces.size())
    return !loop;
  if (k == 0 && !loop)
    return true;
  const Curve &before = k == 0 ? pieces.back() : pieces[k - 1];
  return before.direction_at_end() * pieces[k].direction_at_begin() < straight_on;
}

/// A line whose sides go on straight beyond dents: there the other side of the dent holds what comes, and a
/// trial that goes too far must find the first side still. What is the end of a step ends with the side.
class BeyondDents final : public RestSurface<2>
{
public:
  /// @param share of the shorter side at a dent by which the other one goes on
  BeyondDents(const LineSurface &line, const double share) : line(line), share(share) {}

  SurfacePlace<2> move(const SurfacePlace<2> &place, const dealii::Tensor<1, 1> &way) const override
  {
    const double along = place.along + way[0], length = line.length(place.piece);
    SurfacePlace<2> moved = line.move(place, way);
    const double wanted = along < 0. ? along : along > length ? along - length : 0.;
    if (wanted == 0. || moved.piece != place.piece)
      return moved;
    // The piece that begins in the corner.
    const unsigned int piece = wanted < 0. ? place.piece : following(place.piece);
    const Turn turn(line, piece);
    if (!turn.is_dent())
      return moved;
    const double most = share * std::min(line.length(piece), line.length(turn.last)),
                 by = std::clamp(wanted, -most, most);
    moved.position += by * moved.tangent[0];
    moved.along += by;
    moved.bend[0][0] = 0.;
    moved.at_edge = by != wanted;
    return moved;
  }
  SurfacePlace<2> beyond_edge(const SurfacePlace<2> &place) const override { return line.beyond_edge(place); }

private:
  unsigned int following(const unsigned int piece) const
  {
    unsigned int next = 0;
    while (line.previous(next) != piece)
      ++next;
    return next;
  }

  const LineSurface &line;
  const double share;
};

/// A line's surface as it is drawn.
LineSurface surface_of(const Obstacle<2> &obstacle)
{
  const std::vector<Curve> pieces = without_joints(obstacle.description.pieces);
  std::vector<char> tips;
  for (std::size_t k = 0; k <= pieces.size(); ++k)
    tips.push_back(has_tip(pieces, k));
  return {pieces, std::move(tips)};
}
} // namespace

ObstacleLine::ObstacleLine(const Obstacle<2> &obstacle, const double spacing)
    : RigidRays<2>(obstacle.description.friction)
    , line(surface_of(obstacle))
    , way(obstacle.way)
    , samples(sample(spacing))
{
}

std::optional<SurfacePlace<2>> ObstacleLine::place_at(const unsigned int piece, const double along) const
{
  return piece < line.n_pieces() ? std::make_optional(line.at(piece, along)) : std::nullopt;
}

// Long lines have but a part near a body.
SampledSurface<2> ObstacleLine::facing(const SampledSurface<2> & /*body*/,
                                       const dealii::BoundingBox<2> &near,
                                       const double /*reach*/) const
{
  return part_in(near, samples);
}

double ObstacleLine::largest_way() const
{
  double largest = 0.;
  for (unsigned int piece = 0; piece < line.n_pieces() / 2; ++piece)
    for (const double share : {0., 0.25, 0.5, 0.75, 1.})
      largest = std::max(largest, way_of(line.at(piece, share * line.length(piece))).norm());
  return largest;
}

SampledSurface<2> ObstacleLine::sample(const double spacing) const
{
  SampledSurface<2> result;
  result.spacing = spacing;
  const Pose<2> &pose = way.start;
  const unsigned int n = line.n_pieces() / 2;
  std::vector<unsigned int> first(2 * n), last(2 * n); // samples of every piece
  for (unsigned int step = 0; step < 2 * n; ++step)
  {
    // On along the right side and back along the left one.
    const unsigned int piece = step < n ? step : 3 * n - 1 - step;
    const double length = line.length(piece);
    const unsigned int parts = std::max(1., std::ceil(length / spacing));
    first[piece] = result.samples.size();
    const auto add = [&](const SampledSurface<2>::Sample &sample)
    {
      if (result.samples.size() > first[piece])
        result.neighbours.emplace_back(result.samples.size() - 1, result.samples.size());
      result.samples.push_back(sample);
    };
    for (unsigned int i = 0; i < parts; ++i)
    {
      SampledSurface<2>::Sample sample = sample_of(line.at(piece, i * length / parts), pose);
      if (i == 0 && line.corner_before(piece))
      {
        const Turn turn(line, piece);
        if (turn.is_dent())
          add(sample_of(line.at(turn.last, line.length(turn.last)), pose));
        else
          make_corner(turn, pose, sample);
      }
      add(sample);
    }
    last[piece] = result.samples.size() - 1;
  }
  for (unsigned int piece = 0; piece < 2 * n; ++piece)
    result.neighbours.emplace_back(last[line.previous(piece)], first[piece]);
  return result;
}

RaySide<2> ObstacleLine::meet(const Ray<2> &ray, const double share, const SurfacePlace<2> &guess) const
{
  const Pose<2> pose = way.at(share);
  const auto turn = [&](const Vector &v, const double by) { return pose.turned(v, by); };
  Ray<2> drawn = ray;
  drawn.origin = pose.drawn(ray.origin);
  drawn.direction = turn(ray.direction, -pose.angle);
  drawn.across[0] = turn(ray.across[0], -pose.angle);
  // Where a step begins, tolerances of the one before may lie beyond a dent.
  RaySide<2> side = mpm::meet(drawn, BeyondDents(line, share > 0. ? 0.05 : 1e-4), guess);
  side.normal = turn(side.normal, pose.angle);
  side.way[0] = turn(side.way[0], pose.angle);
  // A rigid line bends along its tangent alone.
  const double bend = trace(side.sliding_twice), length = side.way[0].norm_square();
  side.sliding_twice =
      length > 0. ? bend / length * outer_product(side.way[0], side.way[0]) : dealii::Tensor<2, 2>();
  return side;
}
} // namespace softgrain::mpm
