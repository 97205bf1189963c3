// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/geometry/rigid_surface.h>
#include <softgrain/model/state_file.h>

#include <algorithm>

namespace softgrain
{
namespace
{
template <int dim>
constexpr std::size_t n_numbers = 2 * dim + 4; ///< that the state of an obstacle is made of

/// Where a line is, as one of straight pieces.
void draw(const Obstacle<2> &obstacle, ObstacleState<2> &state)
{
  for (const Curve &piece : obstacle.description.pieces)
  {
    Polygon line = piece.line(0.06); // about a hundred edges in a turn
    if (!state.line.empty())
      line.erase(line.begin());
    for (const dealii::Point<2> &vertex : line)
      state.line.push_back(obstacle.now.placed(vertex));
  }
}

void draw(const Obstacle<3> &obstacle, ObstacleState<3> &state)
{
  TriangulatedSurface drawn = obstacle.description.surface->drawn();
  for (const dealii::Point<3> &vertex : drawn.vertices)
    state.line.push_back(obstacle.now.placed(vertex));
  state.triangles = std::move(drawn.triangles);
}

/// Component of arm x force along the axis about which it turns.
double torque_of(const Pose<2> &, const dealii::Tensor<1, 2> &arm, const dealii::Tensor<1, 2> &force)
{
  return arm[0] * force[1] - arm[1] * force[0];
}

double torque_of(const Pose<3> &now, const dealii::Tensor<1, 3> &arm, const dealii::Tensor<1, 3> &force)
{
  return now.axis * dealii::cross_product_3d(arm, force);
}

template <int dim>
bool is_free(const ObstacleDescription<dim> &obstacle)
{
  return obstacle.drive != nullptr && obstacle.drive->is_free();
}

/// Puts an obstacle @p way further along the way in which it is free.
template <int dim>
void go(const ObstacleDescription<dim> &obstacle, const double way, Pose<dim> &pose)
{
  const dealii::Tensor<1, 3> shift = obstacle.drive->shift();
  for (unsigned int d = 0; d < dim; ++d)
    pose.shift[d] += way * shift[d];
  pose.angle += way * obstacle.drive->turn();
}
} // namespace

template <int dim>
Pose<dim> ObstacleMotion<dim>::at(const double share) const
{
  Pose<dim> pose = start;
  pose.shift += share * (end.shift - start.shift);
  pose.angle += share * (end.angle - start.angle);
  return pose;
}

template <int dim>
ObstacleMotion<dim> Obstacle<dim>::motion(const double time, const double dt) const
{
  ObstacleMotion<dim> planned;
  planned.start = pose_of(description, time);
  planned.end = dt > 0. ? pose_of(description, time + dt) : planned.start;
  planned.dt = dt;
  if (!is_free(description))
    return planned;
  // Half a step ahead a load that depends on the way acts to second order.
  planned.load = description.drive->load(time + 0.5 * dt, {own.way + 0.5 * dt * own.speed, own.speed});
  planned.way = dt * (own.speed + 0.5 * dt * planned.load / description.drive->mass());
  go(description, own.way, planned.start);
  go(description, own.way + planned.way, planned.end);
  return planned;
}

template <int dim>
void Obstacle<dim>::arrive()
{
  now = way.end;
  own.way += way.way;
  force = dealii::Tensor<1, dim>();
  torque = 0.;
}

template <int dim>
void Obstacle<dim>::give(const dealii::Tensor<1, dim> &given,
                         const dealii::Point<dim> &place,
                         const double dt)
{
  const dealii::Tensor<1, dim> arm = place - (now.pivot + now.shift);
  force -= given / dt;
  torque -= torque_of(now, arm, given) / dt;
}

template <int dim>
void Obstacle<dim>::go_on()
{
  if (!is_free(description))
    return;
  const ObstacleDrive &drive = *description.drive;
  double felt = drive.turn() * torque;
  for (unsigned int d = 0; d < dim; ++d)
    felt += drive.shift()[d] * force[d];
  own.speed += way.dt / drive.mass() * (way.load + felt);
}

template <int dim>
ObstacleState<dim> Obstacle<dim>::state() const
{
  ObstacleState<dim> state;
  state.name = description.name;
  state.pivot = now.pivot + now.shift;
  state.angle = now.angle;
  state.force = force;
  state.torque = torque;
  draw(*this, state);
  return state;
}

template <int dim>
std::vector<Obstacle<dim>> make_obstacles(const Scene<dim> &scene)
{
  std::vector<Obstacle<dim>> obstacles;
  for (const ObstacleDescription<dim> &description : scene.obstacles)
  {
    obstacles.push_back({description, {}, {}, {}, 0., 0., {}});
    obstacles.back().plan(0., 0.);
    obstacles.back().arrive();
  }
  return obstacles;
}

template <int dim>
std::vector<ObstacleState<dim>> states_of(const std::vector<Obstacle<dim>> &obstacles)
{
  std::vector<ObstacleState<dim>> states;
  for (const Obstacle<dim> &obstacle : obstacles)
    states.push_back(obstacle.state());
  return states;
}

template <int dim>
bool rough(const std::vector<ObstacleDescription<dim>> &obstacles)
{
  return std::any_of(obstacles.begin(), obstacles.end(),
                     [](const ObstacleDescription<dim> &obstacle) { return obstacle.friction > 0.; });
}

template <int dim>
void save_obstacles(StateWriter &out, const std::string &name, const std::vector<Obstacle<dim>> &obstacles)
{
  if (obstacles.empty())
    return;
  std::vector<double> numbers;
  for (const Obstacle<dim> &obstacle : obstacles)
  {
    for (unsigned int d = 0; d < dim; ++d)
      numbers.push_back(obstacle.force[d]);
    numbers.insert(numbers.end(), {obstacle.torque, obstacle.way.dt});
    for (unsigned int d = 0; d < dim; ++d)
      numbers.push_back(obstacle.way.start.shift[d]);
    numbers.insert(numbers.end(), {obstacle.way.start.angle, obstacle.work});
  }
  out.write(name, numbers);
  std::vector<double> own;
  for (const Obstacle<dim> &obstacle : obstacles)
    if (is_free(obstacle.description))
      own.insert(own.end(), {obstacle.own.way, obstacle.own.speed});
  if (!own.empty())
    out.write(name + "_own", own);
}

template <int dim>
void load_obstacles(const StateReader &in,
                    const std::string &name,
                    const double time,
                    std::vector<Obstacle<dim>> &obstacles)
{
  if (obstacles.empty())
    return;
  const std::vector<double> numbers = in.read_doubles(name, n_numbers<dim> * obstacles.size());
  std::vector<Obstacle<dim> *> loose;
  for (Obstacle<dim> &obstacle : obstacles)
    if (is_free(obstacle.description))
      loose.push_back(&obstacle);
  const std::vector<double> own =
      loose.empty() ? std::vector<double>() : in.read_doubles(name + "_own", 2 * loose.size());
  for (std::size_t o = 0; o < loose.size(); ++o)
    loose[o]->own = {own[2 * o], own[2 * o + 1]};
  for (std::size_t o = 0; o < obstacles.size(); ++o)
  {
    const double *v = &numbers[n_numbers<dim> * o];
    Obstacle<dim> &obstacle = obstacles[o];
    // The way that it came, which bonded primaries look back on.
    obstacle.plan(time, 0.);
    obstacle.arrive();
    for (unsigned int d = 0; d < dim; ++d)
      obstacle.force[d] = *v++;
    obstacle.torque = *v++;
    obstacle.way.dt = *v++;
    for (unsigned int d = 0; d < dim; ++d)
      obstacle.way.start.shift[d] = *v++;
    obstacle.way.start.angle = *v++;
    obstacle.work = *v++;
  }
}

template struct ObstacleMotion<2>;
template struct ObstacleMotion<3>;
template struct Obstacle<2>;
template struct Obstacle<3>;
template std::vector<Obstacle<2>> make_obstacles(const Scene<2> &);
template std::vector<Obstacle<3>> make_obstacles(const Scene<3> &);
template std::vector<ObstacleState<2>> states_of(const std::vector<Obstacle<2>> &);
template std::vector<ObstacleState<3>> states_of(const std::vector<Obstacle<3>> &);
template bool rough(const std::vector<ObstacleDescription<2>> &);
template bool rough(const std::vector<ObstacleDescription<3>> &);
template void save_obstacles(StateWriter &, const std::string &, const std::vector<Obstacle<2>> &);
template void save_obstacles(StateWriter &, const std::string &, const std::vector<Obstacle<3>> &);
template void load_obstacles(const StateReader &, const std::string &, double, std::vector<Obstacle<2>> &);
template void load_obstacles(const StateReader &, const std::string &, double, std::vector<Obstacle<3>> &);
} // namespace softgrain
