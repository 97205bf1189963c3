// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/model/state_file.h>

#include <algorithm>

namespace softgrain
{
namespace
{
constexpr std::size_t n_numbers = 8; // that the state of an obstacle is made of

/// Where a line goes straight on, up to about a degree, there is no corner.
constexpr double straight_on = 0.9998;
} // namespace

Pose ObstacleMotion::at(const double share) const
{
  Pose pose = start;
  pose.shift += share * (end.shift - start.shift);
  pose.angle += share * (end.angle - start.angle);
  return pose;
}

void Obstacle::plan(const double time, const double dt)
{
  way.start = pose_of(description, time);
  way.end = dt > 0. ? pose_of(description, time + dt) : way.start;
  way.dt = dt;
}

void Obstacle::arrive()
{
  now = way.end;
  force = 0.;
  torque = 0.;
}

void Obstacle::give(const dealii::Tensor<1, 2> &given, const dealii::Point<2> &place, const double dt)
{
  const dealii::Tensor<1, 2> arm = place - (now.pivot + now.shift);
  force -= given / dt;
  torque -= (arm[0] * given[1] - arm[1] * given[0]) / dt;
}

ObstacleState<2> Obstacle::state() const
{
  ObstacleState<2> state;
  state.name = description.name;
  state.pivot = now.pivot + now.shift;
  state.angle = now.angle;
  state.force = force;
  state.torque = torque;
  for (const Curve &piece : description.pieces)
  {
    Polygon line = piece.line(0.06); // about a hundred edges in a turn
    if (!state.line.empty())
      line.erase(line.begin());
    for (const dealii::Point<2> &vertex : line)
      state.line.push_back(now.placed(vertex));
  }
  return state;
}

bool Obstacle::has_tip(const std::size_t k) const
{
  const std::vector<Curve> &pieces = description.pieces;
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

dealii::Point<2> Obstacle::tip(const std::size_t k) const
{
  return k == description.pieces.size() ? description.pieces.back().end() : description.pieces[k].begin();
}

std::vector<Obstacle> make_obstacles(const Scene<2> &scene)
{
  std::vector<Obstacle> obstacles;
  for (const ObstacleDescription<2> &description : scene.obstacles)
  {
    obstacles.push_back({description, {}, {}, {}, 0., 0.});
    obstacles.back().plan(0., 0.);
    obstacles.back().arrive();
  }
  return obstacles;
}

std::vector<ObstacleState<2>> states_of(const std::vector<Obstacle> &obstacles)
{
  std::vector<ObstacleState<2>> states;
  for (const Obstacle &obstacle : obstacles)
    states.push_back(obstacle.state());
  return states;
}

bool rough(const std::vector<ObstacleDescription<2>> &obstacles)
{
  return std::any_of(obstacles.begin(), obstacles.end(),
                     [](const ObstacleDescription<2> &obstacle) { return obstacle.friction > 0.; });
}

void save_obstacles(StateWriter &out, const std::string &name, const std::vector<Obstacle> &obstacles)
{
  if (obstacles.empty())
    return;
  std::vector<double> numbers;
  for (const Obstacle &obstacle : obstacles)
    numbers.insert(numbers.end(), {obstacle.force[0], obstacle.force[1], obstacle.torque, obstacle.way.dt,
                                   obstacle.way.start.shift[0], obstacle.way.start.shift[1],
                                   obstacle.way.start.angle, obstacle.work});
  out.write(name, numbers);
}

void load_obstacles(const StateReader &in,
                    const std::string &name,
                    const double time,
                    std::vector<Obstacle> &obstacles)
{
  if (obstacles.empty())
    return;
  const std::vector<double> numbers = in.read_doubles(name, n_numbers * obstacles.size());
  for (std::size_t o = 0; o < obstacles.size(); ++o)
  {
    const double *v = &numbers[n_numbers * o];
    Obstacle &obstacle = obstacles[o];
    // The way that it came, which bonded primaries look back on.
    obstacle.plan(time, 0.);
    obstacle.arrive();
    obstacle.way.dt = v[3];
    obstacle.way.start.shift = dealii::Tensor<1, 2>({v[4], v[5]});
    obstacle.way.start.angle = v[6];
    obstacle.force = dealii::Tensor<1, 2>({v[0], v[1]});
    obstacle.torque = v[2];
    obstacle.work = v[7];
  }
}
} // namespace softgrain
