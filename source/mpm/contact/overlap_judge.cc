// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/overlap_judge.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;
using Box = dealii::BoundingBox<2>;

/// Ways below this are short for any body that a grid resolves [cells].
constexpr double short_way = 0.25;
/// Places on a way that are looked at; a longer way is not allowed.
constexpr unsigned int most_places = 100;

Outline outline_of(const MovedBoundary &boundary)
{
  return {boundary.markers(), boundary.boundary().loop_start, boundary.box()};
}

/// Where markers are at some share of the step, on straight ways.
struct OnTheWay
{
  OnTheWay(const MovedBoundary &boundary, const double before_now)
      : vertices(boundary.markers()), loop_start(boundary.boundary().loop_start)
  {
    for (unsigned int m = 0; m < vertices.size(); ++m)
      vertices[m] -= before_now * boundary.marker_displacements()[m];
  }
  Outline outline() const { return {vertices, loop_start, Box(vertices)}; }

  std::vector<Point> vertices;
  const std::vector<unsigned int> &loop_start;
};

/// Judges what one body has to do with.
class BodyJudge
{
public:
  BodyJudge(const OutlineScene &scene, const MovedOutlines &moved, const unsigned int b)
      : scene(scene), moved(moved), b(b), own(moved.boundaries[b]), outline(outline_of(own))
  {
  }

  Verdict verdict() const
  {
    Verdict verdict;
    if (!scene.bodies[b].rigid.driven)
    {
      look_at_walls(verdict);
      look_at_obstacles(verdict);
      verdict.take(deepest_fold(outline, scene.cell_size), {Meeting::With::body, b, b});
    }
    for (const ContactTask &task : moved.tasks[b])
      look_at_body(task, verdict);
    return verdict;
  }

private:
  void look_at_walls(Verdict &verdict) const
  {
    for (unsigned int w = 0; w < scene.walls.size(); ++w)
    {
      const WallMotion<2> &wall = scene.walls[w];
      if (wall.plane)
        verdict.take(deepest_beyond(outline,
                                    wall.point + scene.share * scene.dt * wall.velocity * wall.normal,
                                    wall.normal),
                     {Meeting::With::wall, b, w});
    }
  }

  void look_at_obstacles(Verdict &verdict) const
  {
    if (scene.obstacles == nullptr)
      return;
    const double spacing = own.boundary().spacing / own.boundary().stride;
    for (unsigned int o = 0; o < scene.obstacles->size(); ++o)
    {
      const Obstacle<2> &obstacle = (*scene.obstacles)[o];
      double way = 0.;
      Polygon here;
      const Pose<2> pose = obstacle.way.at(scene.share);
      for (const Curve &piece : obstacle.description.pieces)
      {
        // Chords of 0.1 rad lie within 0.13 % of the radius.
        const Polygon drawn = piece.line(0.1);
        for (const Point &x : drawn)
          way = std::max(way, scene.dt * obstacle.way.velocity(x).norm());
        here.clear();
        for (const Point &x : drawn)
          here.push_back(pose.placed(x));
        verdict.take(deepest_within(outline, here, spacing), {Meeting::With::obstacle, b, o});
      }
      look_on_the_way(
          own.travel.norm() + own.spread + way, width_of(scene.bodies[b]),
          [&](const double share)
          {
            Intrusion deepest;
            const Pose<2> there = obstacle.way.at(share);
            const OnTheWay body(own, scene.share - share);
            for (const Curve &piece : obstacle.description.pieces)
            {
              Polygon line = piece.line(0.1);
              for (Point &x : line)
                x = there.placed(x);
              deepest.take(deepest_within(body.outline(), line, spacing));
            }
            return deepest.depth;
          },
          {Meeting::With::obstacle, b, o}, verdict);
    }
  }

  void look_at_body(const ContactTask &task, Verdict &verdict) const
  {
    const Meeting meeting{Meeting::With::body, b, task.partner};
    MovedBoundary away;
    const bool image = task.image != PeriodicCell<2>::Image();
    if (image)
      away = image_of(moved.boundaries[task.partner], task.image, scene);
    const MovedBoundary &other = image ? away : moved.boundaries[task.partner];
    verdict.take(deepest_intrusion(outline, outline_of(other)), meeting);
    const double way = (own.travel - other.travel).norm() + own.spread + other.spread;
    if (way <= short_way * scene.cell_size)
      return;
    look_on_the_way(
        way, std::min(width_of(scene.bodies[b]), width_of(scene.bodies[task.partner])),
        [&](const double share)
        {
          const OnTheWay one(own, scene.share - share), two(other, scene.share - share);
          return deepest_intrusion(one.outline(), two.outline()).depth;
        },
        meeting, verdict);
  }

  /// Where the way is longer than what is seen at its ends, places in between are looked at.
  /// @param depth_at how deep the two are in each other at a share of the step [m]
  template <class DepthAt>
  void look_on_the_way(const double way,
                       const double width,
                       const DepthAt &depth_at,
                       const Meeting &meeting,
                       Verdict &verdict) const
  {
    const double allowed = std::max(largest_way_in_widths * width, short_way * scene.cell_size);
    if (scene.share < 1. || way <= allowed)
      return;
    // In a strip that is crossed one of these places is as deep as that.
    const unsigned int n = std::min(most_places, static_cast<unsigned int>(std::ceil(2. * way / allowed)));
    for (unsigned int k = 1; k < n; ++k)
      if (depth_at(static_cast<double>(k) / n) > 0.5 * allowed)
      {
        verdict.take_way(way / allowed, meeting);
        return;
      }
    if (n == most_places)
      verdict.take_way(way / allowed, meeting);
  }

  const OutlineScene &scene;
  const MovedOutlines &moved;
  const unsigned int b;
  const MovedBoundary &own;
  const Outline outline;
};
} // namespace

double width_of(const Body<2> &body)
{
  const std::vector<Point> &markers = body.boundary.position;
  double perimeter = 0.;
  for (unsigned int m = 0; m < markers.size(); ++m)
    perimeter += markers[m].distance(markers[body.boundary.next(m)]);
  return 4. * body.rest.area / perimeter;
}

std::tuple<Meeting::With, unsigned int, unsigned int> Meeting::key() const
{
  if (with == With::body)
    return {with, std::min(body, other), std::max(body, other)};
  return {with, body, other};
}

void Verdict::note_deep(const double depth, const Meeting &meeting)
{
  if (depth <= 0. || (deep.size() == most_deep && depth < deep.back().first))
    return;
  const auto same = std::find_if(deep.begin(), deep.end(),
                                 [&](const auto &other) { return other.second.key() == meeting.key(); });
  if (same != deep.end())
    same->first = std::max(same->first, depth);
  else
    deep.emplace_back(depth, meeting);
  std::sort(deep.begin(), deep.end(),
            [](const auto &a, const auto &b)
            { return a.first != b.first ? a.first > b.first : a.second.key() < b.second.key(); });
  if (deep.size() > most_deep)
    deep.pop_back();
}

void Verdict::take(const Intrusion &found, const Meeting &meeting)
{
  note_deep(found.depth, meeting);
  if (found.depth > deepest.depth)
  {
    deepest = found;
    overlap = meeting;
  }
}

void Verdict::take_way(const double share, const Meeting &meeting)
{
  if (share > way)
  {
    way = share;
    passing = meeting;
  }
}

void Verdict::take(const Verdict &other)
{
  // Of symmetric pairs, which may have different owners, the same one wherever it is told.
  if (other.deepest.depth > deepest.depth ||
      (other.deepest.depth == deepest.depth && other.overlap.body < overlap.body))
  {
    deepest = other.deepest;
    overlap = other.overlap;
  }
  if (other.way > way || (other.way == way && other.passing.body < passing.body))
  {
    way = other.way;
    passing = other.passing;
  }
  for (const auto &[depth, meeting] : other.deep)
    note_deep(depth, meeting);
}

Verdict::Numbers Verdict::numbers() const
{
  Numbers result = {deepest.depth, deepest.place[0], deepest.place[1], way};
  const auto add = [&](const Meeting &meeting)
  {
    for (const unsigned int n : {static_cast<unsigned int>(meeting.with), meeting.body, meeting.other})
      result.push_back(n);
  };
  add(overlap);
  add(passing);
  for (unsigned int k = 0; k < most_deep; ++k)
  {
    result.push_back(k < deep.size() ? deep[k].first : 0.);
    add(k < deep.size() ? deep[k].second : Meeting());
  }
  return result;
}

Verdict Verdict::of(const Numbers &n)
{
  const auto meeting = [&n](const unsigned int i) -> Meeting
  {
    return {static_cast<Meeting::With>(static_cast<int>(n[i])), static_cast<unsigned int>(n[i + 1]),
            static_cast<unsigned int>(n[i + 2])};
  };
  Verdict verdict;
  verdict.deepest = {n[0], Point(n[1], n[2])};
  verdict.way = n[3];
  verdict.overlap = meeting(4);
  verdict.passing = meeting(7);
  for (unsigned int i = 10; i < n.size() && n[i] > 0.; i += 4)
    verdict.deep.emplace_back(n[i], meeting(i + 1));
  return verdict;
}

Verdict judge_outlines(const OutlineScene &scene, const MovedOutlines &moved)
{
  std::vector<Verdict> of_body(scene.bodies.size());
  parallel_for(of_body.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (scene.looking == nullptr || scene.looking->mine(b))
                     of_body[b] = BodyJudge(scene, moved, b).verdict();
               });
  Verdict verdict;
  for (const Verdict &found : of_body)
    verdict.take(found);
  return verdict;
}
} // namespace softgrain::mpm
