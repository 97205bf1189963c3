// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/contact/obstacle_solid.h>
#include <softgrain/mpm/contact/overlap_judge.h>
#include <softgrain/mpm/stepping/safe_step.h>
#include <softgrain/mpm/stepping/step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// How a body moves, and where it is.
template <int dim>
struct Flight
{
  dealii::Tensor<1, dim> velocity; ///< mean [m/s]
  double spread = 0.;              ///< of the velocities of its outline about the mean [m/s]
  double width = 0.;               ///< of the body where it is narrowest [m]
  dealii::Point<dim> lower, upper; ///< of the box around it [m]

  static constexpr unsigned int n_numbers = 3 * dim + 2;
  using Numbers = std::array<double, n_numbers>;
  Numbers numbers() const
  {
    Numbers list;
    for (unsigned int d = 0; d < dim; ++d)
    {
      list[d] = velocity[d];
      list[dim + 2 + d] = lower[d];
      list[2 * dim + 2 + d] = upper[d];
    }
    list[dim] = spread;
    list[dim + 1] = width;
    return list;
  }
};

Flight<2> flight_of(const Flight<2>::Numbers &n)
{
  return {Vector({n[0], n[1]}), n[2], n[3], {n[4], n[5]}, {n[6], n[7]}};
}

/// Balls, the only bodies in space, are as wide as they are at rest.
double width_of(const Body<3> &body)
{
  return std::cbrt(6. / M_PI * body.rest.area);
}

template <int dim>
Flight<dim> flight_of(const Body<dim> &body, const dealii::Tensor<1, dim> &drive)
{
  Flight<dim> flight;
  const unsigned int n = body.nodes.velocity.size() / dim;
  const double mass = body.nodes.mass.sum();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int d = 0; d < dim; ++d)
      flight.velocity[d] += body.nodes.mass[i] / mass * body.nodes.velocity[dim * i + d];
  if (body.rigid.driven)
    flight.velocity = drive;
  else if (n > 0)
  {
    // Of the outline, not of the nodes: those on the rim may be fast and move nothing.
    Eigen::VectorXd about_mean = body.nodes.velocity;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        about_mean[dim * i + d] -= flight.velocity[d];
    flight.spread = largest_way(body, about_mean);
  }
  const std::vector<dealii::Point<dim>> &markers = body.boundary.position;
  flight.lower = flight.upper = markers.front();
  for (const dealii::Point<dim> &x : markers)
    for (unsigned int d = 0; d < dim; ++d)
    {
      flight.lower[d] = std::min(flight.lower[d], x[d]);
      flight.upper[d] = std::max(flight.upper[d], x[d]);
    }
  flight.width = width_of(body);
  return flight;
}

template <int dim>
double distance(const Flight<dim> &a, const Flight<dim> &b)
{
  dealii::Tensor<1, dim> apart;
  for (unsigned int d = 0; d < dim; ++d)
    apart[d] = std::max({0., a.lower[d] - b.upper[d], b.lower[d] - a.upper[d]});
  return apart.norm();
}

/// Time in which @p way is gone from @p speed on with @p acceleration [s].
double time_of_way(const double way, const double speed, const double acceleration)
{
  return 2. * way / (speed + std::sqrt(speed * speed + 2. * acceleration * way));
}

/// Acceleration by which bodies fall [m/s²]; without inertia time only orders the steps.
double pull_of(const Problem &problem, const State &state)
{
  return problem.settings.scheme.ends_in_balance() ? 0. : problem.scene.loads.uniform(state.time).norm();
}

/// The longest step, up to @p dt, in which @p flight comes nearer to no wall by more than @p reach.
double safe_from_walls(
    const Problem &problem, const State &state, const Flight<2> &flight, const double reach, const double dt)
{
  double step = dt;
  for (const Wall<2> &wall : state.walls)
  {
    if (wall.description.type != WallDescription<2>::Type::plane)
      continue;
    const Vector &n = wall.normal();
    const dealii::Point<2> nearest(n[0] > 0. ? flight.lower[0] : flight.upper[0],
                                   n[1] > 0. ? flight.lower[1] : flight.upper[1]);
    const double gap = (nearest - wall.point()) * n;
    const double own = expected_rates(wall, state.time, dt).speed;
    const double speed = std::max(0., own - flight.velocity * n) + flight.spread;
    step = std::min(step, time_of_way(std::max(reach, gap), speed, pull_of(problem, state)));
  }
  return step;
}

/// The longest step, up to @p dt, in which two bodies cannot pass through each other. @param pull
/// acceleration by which bodies fall, all alike: it adds to the way to what is driven alone
template <int dim>
double safe_from_bodies(const std::vector<Body<dim>> &bodies,
                        const double pull,
                        const std::vector<Flight<dim>> &flights,
                        const double reach,
                        const double dt)
{
  double fastest = 0., narrowest = std::numeric_limits<double>::max();
  for (const Flight<dim> &flight : flights)
  {
    fastest = std::max(fastest, flight.velocity.norm() + flight.spread);
    narrowest = std::min(narrowest, flight.width);
  }
  // Most steps are short: no pair need be looked at.
  if (time_of_way(std::min(largest_way_in_widths * narrowest, reach), 2. * fastest, pull) >= dt)
    return dt;
  double step = dt;
  for (unsigned int a = 0; a < flights.size(); ++a)
    for (unsigned int b = 0; b < a; ++b)
    {
      const bool one_driven = bodies[a].rigid.driven, other_driven = bodies[b].rigid.driven;
      if (one_driven && other_driven)
        continue;
      const Flight<dim> &one = flights[a], &other = flights[b];
      const double speed = (one.velocity - other.velocity).norm() + one.spread + other.spread;
      const double allowed = std::min(largest_way_in_widths * std::min(one.width, other.width), reach);
      step = std::min(step, time_of_way(std::max(allowed, distance(one, other)), speed,
                                        one_driven || other_driven ? pull : 0.));
    }
  return step;
}

/// The longest step, up to @p dt, in which no body can pass through an obstacle.
double safe_from_obstacles(const Problem &problem,
                           const State &state,
                           const std::vector<Flight<2>> &flights,
                           const double reach,
                           const double dt)
{
  double step = dt;
  for (Obstacle<2> obstacle : state.obstacles)
  {
    obstacle.plan(state.time, dt);
    double speed = 0.;
    Flight<2> line;
    line.lower = dealii::Point<2>(std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
    line.upper = -line.lower;
    for (const Curve &piece : obstacle.description.pieces)
      for (const dealii::Point<2> &drawn : piece.line(0.1))
      {
        const dealii::Point<2> here = obstacle.way.start.placed(drawn);
        speed = std::max(speed, obstacle.way.velocity(drawn).norm());
        for (unsigned int d = 0; d < 2; ++d)
        {
          line.lower[d] = std::min(line.lower[d], here[d]);
          line.upper[d] = std::max(line.upper[d], here[d]);
        }
      }
    for (unsigned int b = 0; b < flights.size(); ++b)
      if (!state.bodies[b].rigid.driven)
        step = std::min(step, time_of_way(std::max(std::min(largest_way_in_widths * flights[b].width, reach),
                                                   distance(flights[b], line)),
                                          flights[b].velocity.norm() + flights[b].spread + speed,
                                          pull_of(problem, state)));
  }
  return step;
}

/// Safe step of bodies in a cell that repeats, where every body may be near any other.
double safe_in_cell(const Problem &problem,
                    const State &state,
                    const std::vector<Flight<2>> &flights,
                    const double reach,
                    const double dt)
{
  double fastest = 0., narrowest = std::numeric_limits<double>::max(), widest = 0.;
  for (const Flight<2> &flight : flights)
  {
    fastest = std::max(fastest, flight.velocity.norm() + flight.spread);
    narrowest = std::min(narrowest, flight.width);
    widest = std::max(widest, flight.lower.distance(flight.upper));
  }
  CellMotion<2> cell;
  cell.cell = cell_of(state.walls);
  for_sides(state.walls,
            [&](const Wall<2> &side)
            {
              const WallRates rates = expected_rates(side, state.time, dt);
              cell.add_side(side.normal(), rates.speed * side.normal() + rates.slide * side.tangent());
            });
  return std::min(dt, time_of_way(std::min(largest_way_in_widths * narrowest, reach),
                                  2. * fastest + cell.gradient.norm() * widest, pull_of(problem, state)));
}
} // namespace

double safe_step(const Problem &problem, const State &state, const Workspace &work, const double dt)
{
  // Rays of an implicit step see all that bodies come to meet, and an overlap that is left repeats the step;
  // rows are those of its start or its middle.
  const bool follow = problem.settings.follows_contact();
  if (follow && state.bodies.size() < 2 && state.obstacles.empty())
    return dt;
  const double reach = follow ? std::numeric_limits<double>::max() : 0.5 * problem.lattice->cell_size();
  const auto told = work.share.numbers<Flight<2>::n_numbers>(state.bodies, [&](const Body<2> &body)
                                                             { return flight_of(body, Vector()).numbers(); });
  std::vector<Flight<2>> flights;
  for (const Body<2> &body : state.bodies)
    flights.push_back(body.rigid.driven ? flight_of(body, work.drive[body.index])
                                        : flight_of(told[body.index]));
  if (state.repeats())
    return safe_in_cell(problem, state, flights, reach, dt);
  double step = safe_from_bodies(state.bodies, pull_of(problem, state), flights, reach, dt);
  step = safe_from_obstacles(problem, state, flights, reach, step);
  if (!follow)
    for (unsigned int b = 0; b < flights.size(); ++b)
      if (!state.bodies[b].rigid.driven)
        step = safe_from_walls(problem, state, flights[b], reach, step);
  return step;
}

double safe_step_in_space(const std::vector<Body<3>> &bodies,
                          const std::vector<Obstacle<3>> &obstacles,
                          const double time,
                          const double dt)
{
  std::vector<Flight<3>> flights;
  for (const Body<3> &body : bodies)
    flights.push_back(flight_of(body, dealii::Tensor<1, 3>()));
  double step = safe_from_bodies(bodies, 0., flights, std::numeric_limits<double>::max(), dt);
  for (const Obstacle<3> &obstacle : obstacles)
  {
    const ObstacleSolid solid(obstacle, obstacle.motion(time, dt));
    const double speed = solid.largest_way() / dt;
    Flight<3> there;
    std::tie(there.lower, there.upper) = solid.box();
    for (const Flight<3> &flight : flights)
      step =
          std::min(step, time_of_way(std::max(largest_way_in_widths * flight.width, distance(flight, there)),
                                     flight.velocity.norm() + flight.spread + speed, 0.));
  }
  return step;
}
} // namespace softgrain::mpm
