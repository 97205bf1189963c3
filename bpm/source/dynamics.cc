// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/timed_section.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::bpm
{
namespace
{
/// Primaries or rows that a thread takes at a time.
constexpr std::size_t grain = 4096;

/// Gap up to which primaries touch for adhesion [mean diameters]; contact solutions leave less.
constexpr double touching = 1e-3;

contact::NeighbourList::Range range_of(const double contact_reach,
                                       const double skin,
                                       const std::vector<std::shared_ptr<const Attraction>> &laws,
                                       const double diameter)
{
  contact::NeighbourList::Range range;
  range.gap = contact_reach * diameter;
  range.skin = skin * diameter;
  for (const auto &law : laws)
    if (law)
      range.stretch = std::max(range.stretch, law->range());
  return range;
}

/// Work that @p wall has done in the step.
void book(const double work, Wall<2> &wall, DynamicsReport &report)
{
  wall.book.work += work;
  report.wall_work += work;
}

/// The same of a wall that is told how to move.
void book_told(const double work, Wall<2> &wall, DynamicsReport &report)
{
  book(work, wall, report);
  report.contact_loss += work;
}
} // namespace

bool DynamicsSettings::rotations() const
{
  return !pairs.frictionless() || any_rolling();
}

double DynamicsSettings::reach() const
{
  // The limit on penetration sees those that close faster.
  constexpr double farthest_look = 0.1;
  return look_ahead > 0. ? std::max(contact_range, farthest_look) : contact_range;
}

Dynamics::Dynamics(Primaries disks,
                   std::vector<std::shared_ptr<const Attraction>> attraction,
                   std::vector<bool> fixed_bodies,
                   const DynamicsSettings &dynamics_settings,
                   dealii::TimerOutput *const timer)
    : primaries(std::move(disks))
    , laws(std::move(attraction))
    , settings(dynamics_settings)
    , rotations(primaries.rotate())
    , timer(timer)
    , fixed(std::move(fixed_bodies))
{
  diameter = primaries.mean_diameter();
  smallest = 2. * *std::min_element(primaries.radius.begin(), primaries.radius.end());
  if (settings.pairs.adhere())
    remembered.adhesion = Adhesion(settings.contact_law, touching * diameter);
  weigh();
  const bool attracted = std::any_of(laws.begin(), laws.end(), [](const auto &law) { return bool(law); });
  list = contact::NeighbourList(primaries.radius, attracted ? primaries.body : std::vector<std::uint32_t>(),
                                range_of(contact_reach(), settings.skin, laws, diameter),
                                !rotations               ? 1
                                : settings.any_rolling() ? 3
                                                         : 2);
}

void Dynamics::keep_motion(const bool keeps)
{
  kept = Motion();
  if (!keeps)
    return;
  kept.position = primaries.position;
  kept.velocity = primaries.velocity;
  kept.angular_velocity = primaries.angular_velocity;
}

void Dynamics::weigh()
{
  inverse_mass.resize(primaries.size());
  for (std::size_t i = 0; i < primaries.size(); ++i)
    inverse_mass[i] = !fixed.empty() && fixed[primaries.body[i]] ? 0. : 1. / primaries.mass[i];
}

double Dynamics::contact_reach() const
{
  return std::max(settings.reach(), remembered.adhesion.reach() / diameter);
}

void Dynamics::prepare_bodies(const double dt,
                              const std::vector<Wall<2>> &walls,
                              const std::vector<std::array<double, 2>> &acceleration)
{
  const std::size_t n = primaries.size();
  const std::size_t n_all = n + walls.size() + (obstacles != nullptr ? obstacles->size() : 0);
  bodies.velocity.resize(n_all);
  bodies.inverse_mass = inverse_mass;
  bodies.inverse_mass.resize(n_all);
  parallel_for(n, grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   for (unsigned int d = 0; d < 2; ++d)
                   {
                     bodies.velocity[i][d] = primaries.velocity[i][d] + dt * inverse_mass[i] * force[i][d];
                     if (!acceleration.empty() && inverse_mass[i] > 0.)
                       bodies.velocity[i][d] += dt * acceleration[i][d];
                   }
               });
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    const Wall<2> &wall = walls[w];
    const WallAhead ahead = ahead_of(wall, dt, 1.);
    bodies.inverse_mass[n + w] = 1. / ahead.across.mass;
    const dealii::Tensor<1, 2> velocity = ahead.velocity(wall);
    for (unsigned int d = 0; d < 2; ++d)
      bodies.velocity[n + w][d] = velocity[d];
  }
  if (cell)
    prepare_cell(dt, walls);
  if (rotations)
  {
    bodies.angular_velocity = primaries.angular_velocity;
    bodies.angular_velocity.resize(n_all, 0.);
    bodies.inverse_inertia.assign(n_all, 0.);
    for (std::size_t i = 0; i < n; ++i)
      bodies.inverse_inertia[i] = 2. * inverse_mass[i] / (primaries.radius[i] * primaries.radius[i]);
    for (std::size_t w = 0; w < walls.size(); ++w)
      bodies.inverse_inertia[n + w] = 1. / ahead_of(walls[w], dt, 1.).along.mass;
  }
}

void Dynamics::prepare_gap_velocities(const double dt, const std::vector<Wall<2>> &walls)
{
  const std::size_t n = primaries.size();
  parallel_for(rows.size(), grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 // An open gap may close within the step; of an overlap a share is pushed out.
                 for (std::size_t row = begin; row < end; ++row)
                   rows.gap_velocity[row] =
                       (gap[row] > 0. ? gap[row] : settings.gap_correction * gap[row]) / dt;
               });
  if (settings.restitution == 0.)
    return;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    // Newton's law of impact, in the step in which the gap would close.
    double before = 0.;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const std::size_t b = rows.b[row];
      const double of_b = b < n                  ? primaries.velocity[b][d]
                          : b - n < walls.size() ? walls[b - n].speed * walls[b - n].normal()[d]
                                                 : obstacle_velocity(row)[d];
      before += rows.normal[row][d] * (primaries.velocity[rows.a[row]][d] - of_b);
      if (cell)
        before += rows.normal[row][d] *
                  (cell->gradient[d][0] * rows.branch[row][0] + cell->gradient[d][1] * rows.branch[row][1]);
    }
    if (before < 0. && gap[row] + dt * before <= 0.)
      rows.gap_velocity[row] = settings.restitution * before;
  }
}

void Dynamics::let_go(const double dt,
                      const std::size_t w,
                      const Freedom direction,
                      const double push,
                      Wall<2> &wall,
                      DynamicsReport &report) const
{
  const std::array<double, 2> &v = bodies.velocity[primaries.size() + w];
  const dealii::Tensor<1, 2> way = way_of(wall, direction);
  const double before = speed_of(wall, direction), mass = load_on(wall, direction).mass;
  const double after = v[0] * way[0] + v[1] * way[1];
  // The damping took what neither the load nor the primaries gave.
  const double load = dt * load_on(wall, direction).force, damping = mass * (before - after) + load + push;
  book(load * 0.5 * (before + after), wall, report);
  report.damping_loss += damping * 0.5 * (before + after);
  report.contact_loss +=
      0.5 * mass * (before * before - after * after) + (load - damping) * 0.5 * (before + after);
  speed_of(wall, direction) = after;
}

void Dynamics::move_walls(const double dt, std::vector<Wall<2>> &walls, DynamicsReport &report)
{
  const std::size_t n = primaries.size();
  std::vector<double> normal_impulse(walls.size(), 0.), tangential_impulse(walls.size(), 0.);
  for (std::size_t row = rows.tile_start.back(); row < rows.size() - obstacle_rows.size(); ++row)
  {
    normal_impulse[rows.b[row] - n] += rows.impulse[row];
    if (rotations)
      tangential_impulse[rows.b[row] - n] += rows.tangential_impulse[row];
  }
  if (cell)
    load_cell(dt, walls, normal_impulse);
  if (share)
    tell_of_walls(normal_impulse, tangential_impulse);
  for_met(walls,
          [&](Wall<2> &wall, const std::size_t w)
          {
            wall.book.force = 0.;
            const dealii::Tensor<1, 2> given =
                normal_impulse[w] * wall.normal() - tangential_impulse[w] * wall.tangent();
            wall.book.give(given, dt);
            report.wall_impulse += given;
          });
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    Wall<2> &wall = walls[w];
    const double along = wall.book.force * wall.tangent();
    if (is_free(wall, Freedom::along))
      let_go(dt, w, Freedom::along, dt * along, wall, report);
    else if (wall.slide_speed != 0.)
      book_told(-dt * wall.slide_speed * along, wall, report);
    if (is_free(wall, Freedom::across))
      let_go(dt, w, Freedom::across, -normal_impulse[w], wall, report);
    else
      book_told(normal_impulse[w] * wall.speed, wall, report);
    wall.travel += dt * wall.speed;
  }
}

void Dynamics::move_primaries(const double dt)
{
  const std::size_t n = primaries.size();
  parallel_for(n, grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                 {
                   if (!std::isfinite(bodies.velocity[i][0] + bodies.velocity[i][1]))
                     throw ComputationError("primary " + std::to_string(primaries.number_of(i)) +
                                            " of body " + std::to_string(primaries.body[i]) +
                                            " has no finite velocity");
                   primaries.velocity[i] = bodies.velocity[i];
                   for (unsigned int d = 0; d < 2; ++d)
                     primaries.position[i][d] += dt * primaries.velocity[i][d];
                 }
               });
  if (rotations)
    std::copy_n(bodies.angular_velocity.begin(), n, primaries.angular_velocity.begin());
}

DynamicsReport Dynamics::step(const double dt,
                              std::vector<Wall<2>> &walls,
                              const std::vector<std::array<double, 2>> &acceleration,
                              const std::vector<std::vector<std::array<double, 2>>> &of_loads)
{
  DynamicsReport report;
  {
    const TimedSection section(timer, "free motion");
    prepare_bodies(dt, walls, acceleration);
    prepare_gap_velocities(dt, walls);
    if (obstacles != nullptr)
      drive_obstacles(walls.size());
  }
  {
    const TimedSection section(timer, "contact solve");
    contact::DiskSolverSettings solver = settings.solver;
    solver.wall_floor = settings.wall_force_floor * dt;
    solver.penetration_tolerance = settings.solver_penetration * diameter / dt;
    shift_cones(dt, false);
    report.solver = contact::solve_disks(bodies, rows, solver, exchange, share ? &exchanges : nullptr);
    shift_cones(dt, true);
  }

  {
    const TimedSection section(timer, "motion");
    report.adhesion_work = adhesion_work(dt, walls);
    move_walls(dt, walls, report);
    if (obstacles != nullptr)
      move_obstacles(dt, report);
    account(dt, acceleration, of_loads, report);
    account_driven(dt, report);
    report.contact_loss += report.adhesion_work;
    note_contacts(dt);
    alike([&]() { move_primaries(dt); });
    if (cell)
      take_along(dt, walls, report);
    remember();
    report.on_the_way = deepest_on_the_way(dt);
  }
  detect(walls);
  report.max_penetration = std::max(deepest, report.on_the_way.depth);
  return report;
}
} // namespace softgrain::bpm
