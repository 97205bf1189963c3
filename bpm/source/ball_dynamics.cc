// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/ball_dynamics.h>
#include <softgrain/bpm/timed_section.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::bpm
{
namespace
{
/// Balls or rows that a thread takes at a time.
constexpr std::size_t grain = 4096;

dealii::Tensor<1, 3> tensor_of(const std::array<double, 3> &x)
{
  return dealii::Tensor<1, 3>({x[0], x[1], x[2]});
}

double product(const std::array<double, 3> &x, const std::array<double, 3> &y)
{
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
} // namespace

BallDynamics::BallDynamics(Balls balls,
                           std::vector<std::shared_ptr<const Attraction>> attraction,
                           const DynamicsSettings &dynamics_settings)
    : primaries(std::move(balls))
    , laws(std::move(attraction))
    , settings(dynamics_settings)
    , rotations(primaries.rotate())
{
  diameter = primaries.mean_diameter();
  for (std::size_t i = 0; i < primaries.size(); ++i)
  {
    inverse_mass.push_back(1. / primaries.mass[i]);
    inverse_inertia.push_back(2.5 * inverse_mass[i] / (primaries.radius[i] * primaries.radius[i]));
  }
  contact::NeighbourList::Range range;
  range.gap = contact_reach() * diameter;
  range.skin = settings.skin * diameter;
  bool attracted = false;
  for (const auto &law : laws)
    if (law)
    {
      range.stretch = std::max(range.stretch, law->range());
      attracted = true;
    }
  list = contact::BallList(primaries.radius, attracted ? primaries.body : std::vector<std::uint32_t>(), range,
                           rotations ? 4 : 1);
}

void BallDynamics::keep_motion()
{
  kept = {primaries.position, primaries.velocity, primaries.angular_velocity};
}

void BallDynamics::take_back_motion(const Walls &walls)
{
  primaries.position = kept.position;
  primaries.velocity = kept.velocity;
  primaries.angular_velocity = kept.angular_velocity;
  detect(walls);
}

void BallDynamics::prepare_bodies(const double dt,
                                  const Walls &walls,
                                  const std::vector<std::vector<Vector>> &of_loads)
{
  const std::size_t n = primaries.size(), n_all = n + walls.size();
  bodies.velocity.resize(n_all);
  bodies.inverse_mass = inverse_mass;
  bodies.inverse_mass.resize(n_all, 0.);
  parallel_for(n, grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   for (unsigned int d = 0; d < 3; ++d)
                   {
                     double &velocity = bodies.velocity[i][d];
                     velocity = primaries.velocity[i][d] + dt * inverse_mass[i] * force[i][d];
                     for (const std::vector<Vector> &load : of_loads)
                       velocity += dt * load[i][d];
                   }
               });
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    const dealii::Tensor<1, 3> v = walls[w].velocity();
    bodies.velocity[n + w] = {v[0], v[1], v[2]};
  }
  if (!rotations)
    return;
  bodies.angular_velocity = primaries.angular_velocity;
  bodies.angular_velocity.resize(n_all, Vector{});
  bodies.inverse_inertia = inverse_inertia;
  bodies.inverse_inertia.resize(n_all, 0.);
}

void BallDynamics::prepare_gap_velocities(const double dt, const Walls &walls)
{
  // An open gap may close within the step; of an overlap a share is pushed out.
  for (std::size_t row = 0; row < rows.size(); ++row)
    rows.gap_velocity[row] = (gap[row] > 0. ? gap[row] : settings.gap_correction * gap[row]) / dt;
  if (settings.restitution == 0.)
    return;
  const std::size_t n = primaries.size();
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    // Newton's law of impact, in the step in which the gap would close.
    const std::size_t b = rows.b[row];
    const double of_a = product(rows.normal[row], primaries.velocity[rows.a[row]]),
                 of_b = b < n ? product(rows.normal[row], primaries.velocity[b]) : walls[b - n].speed,
                 before = of_a - of_b;
    if (before < 0. && gap[row] + dt * before <= 0.)
      rows.gap_velocity[row] = settings.restitution * before;
  }
}

void BallDynamics::move_walls(const double dt, Walls &walls, BallReport &report)
{
  const std::size_t n = primaries.size();
  std::vector<dealii::Tensor<1, 3>> given(walls.size());
  for (std::size_t row = pair_of_row.size(); row < rows.size(); ++row)
  {
    dealii::Tensor<1, 3> &impulse = given[rows.b[row] - n];
    impulse += rows.impulse[row] * tensor_of(rows.normal[row]);
    if (rotations)
      impulse += tensor_of(rows.tangential_impulse[row]);
  }
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    Wall<3> &wall = walls[w];
    const double before = wall.book.work;
    wall.book.force = dealii::Tensor<1, 3>();
    wall.book.give(given[w], dt);
    wall.book.work += given[w] * wall.velocity();
    wall.travel += dt * wall.speed;
    report.contact_loss += wall.book.work - before;
    report.impulse += given[w];
  }
}

void BallDynamics::account(const double dt,
                           const std::vector<std::vector<Vector>> &of_loads,
                           BallReport &report) const
{
  // Work is impulse times the mean of the velocities before and after, so that the books balance to rounding
  // but for the work of the attraction, which is compared with its potential.
  report.load_work.assign(of_loads.size(), 0.);
  for (std::size_t i = 0; i < primaries.size(); ++i)
  {
    const double mass = primaries.mass[i];
    double loss = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double before = primaries.velocity[i][d], after = bodies.velocity[i][d],
                   way = 0.5 * dt * (before + after);
      loss += 0.5 * mass * (before - after) * (before + after) + force[i][d] * way;
      for (std::size_t load = 0; load < of_loads.size(); ++load)
      {
        const double push = mass * of_loads[load][i][d];
        report.load_work[load] += push * way;
        report.impulse[d] += dt * push;
        loss += push * way;
      }
      if (rotations)
        loss += 0.5 / inverse_inertia[i] *
                (primaries.angular_velocity[i][d] - bodies.angular_velocity[i][d]) *
                (primaries.angular_velocity[i][d] + bodies.angular_velocity[i][d]);
    }
    report.contact_loss += loss;
  }
}

void BallDynamics::move_balls(const double dt, BallReport &report)
{
  for (std::size_t i = 0; i < primaries.size(); ++i)
  {
    const Vector &v = bodies.velocity[i];
    const double speed = std::sqrt(product(v, v));
    if (!std::isfinite(speed))
      throw ComputationError("primary " + std::to_string(i) + " of body " +
                             std::to_string(primaries.body[i]) + " has no finite velocity");
    report.farthest = std::max(report.farthest, dt * speed / primaries.radius[i]);
    primaries.velocity[i] = v;
    for (unsigned int d = 0; d < 3; ++d)
      primaries.position[i][d] += dt * v[d];
  }
  if (rotations)
    std::copy_n(bodies.angular_velocity.begin(), primaries.size(), primaries.angular_velocity.begin());
}

void BallDynamics::remember()
{
  const auto impulses = [&](const std::size_t row, double *const to)
  {
    to[0] = rows.impulse[row];
    if (rotations)
      std::copy_n(rows.tangential_impulse[row].begin(), 3, to + 1);
  };
  std::fill(list.all_memories().begin(), list.all_memories().end(), 0.);
  for (std::size_t row = 0; row < pair_of_row.size(); ++row)
    impulses(row, list.memory(pair_of_row[row]));
  remembered_at_walls.clear();
  for (std::size_t row = pair_of_row.size(); row < rows.size(); ++row)
  {
    remembered_at_walls.push_back(
        {static_cast<std::uint32_t>(rows.b[row] - primaries.size()), rows.a[row], {}});
    impulses(row, remembered_at_walls.back().impulse.data());
  }
}

BallReport BallDynamics::step(const double dt, Walls &walls, const std::vector<std::vector<Vector>> &of_loads)
{
  BallReport report;
  {
    const TimedSection section(timer, "free motion");
    prepare_bodies(dt, walls, of_loads);
    prepare_gap_velocities(dt, walls);
  }
  {
    const TimedSection section(timer, "contact solve");
    contact::DiskSolverSettings solver = settings.solver;
    solver.wall_floor = settings.wall_force_floor * dt;
    solver.penetration_tolerance = settings.solver_penetration * diameter / dt;
    report.solver = contact::solve_balls(bodies, rows, solver);
  }
  {
    const TimedSection section(timer, "motion");
    move_walls(dt, walls, report);
    account(dt, of_loads, report);
    move_balls(dt, report);
    remember();
  }
  detect(walls);
  report.max_penetration = deepest;
  return report;
}

BallSums BallDynamics::sums() const
{
  BallSums sums;
  for (std::size_t i = 0; i < primaries.size(); ++i)
  {
    const Vector &v = primaries.velocity[i];
    sums.kinetic += 0.5 * primaries.mass[i] * product(v, v);
    if (rotations)
      sums.kinetic +=
          0.5 / inverse_inertia[i] * product(primaries.angular_velocity[i], primaries.angular_velocity[i]);
    sums.momentum += primaries.mass[i] * tensor_of(v);
    sums.moving += primaries.mass[i] * std::sqrt(product(v, v));
  }
  sums.attraction = stored_energy;
  sums.n_pushing =
      std::count_if(rows.impulse.begin(), rows.impulse.end(), [](const double P) { return P > 0.; });
  return sums;
}
} // namespace softgrain::bpm
