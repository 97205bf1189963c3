// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/world.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain::mpm
{
World::World() = default;
World::~World() = default;

void World::sort_points()
{
  points->sort();
  std::vector<std::vector<BodyPoints<2>::Handle>> lists = points->by_body(bodies.size());
  for (unsigned int b = 0; b < bodies.size(); ++b)
    bodies[b].points.renew(std::move(lists[b]));
}

SubgridCompliance World::subgrid() const
{
  return {settings.subgrid_compliance() && places_are_free() && !pairs.adhere(), lattice->cell_size()};
}

std::vector<WallMotion<2>> World::wall_motion(const StepPlan &plan)
{
  for (Obstacle &obstacle : obstacles)
    obstacle.plan(time, plan.held ? 0. : plan.dt);
  std::vector<WallMotion<2>> motion;
  for (const Wall &wall : walls)
  {
    const double velocity = plan.held || !wall.prescribed() ? 0. : wall.demand(time, plan.dt).velocity;
    motion.push_back({wall.point(), wall.normal(), velocity, wall.body == Wall::no_body && !wall.repeats(),
                      velocity, std::abs(velocity),
                      plan.held || wall.slides_freely() ? 0. : wall.demanded_slide(time, plan.dt)});
  }
  for (const FreeWall<2> &free : contact.free_walls.list)
    if (!free.slides() || free.length > 0.)
      motion[free.wall].fastest = std::max(
          motion[free.wall].fastest,
          free.stop > 0. ? free.stop : std::max(std::abs(free.start_speed), std::abs(free.free_speed)));
  for (unsigned int w = 0; w < walls.size(); ++w)
    if (walls[w].body != Wall::no_body)
      bodies[walls[w].body].drive =
          motion[w].velocity * motion[w].normal + motion[w].slide * motion[w].tangent();
  return motion;
}

std::string World::why_not(const unsigned int body, const StressOutcome &outcome) const
{
  std::ostringstream text;
  text << "a material point of body '" << bodies[body].name << "' "
       << (!outcome.refusal.empty() ? outcome.refusal
           : outcome.leaps          ? "deformed by more than 'Newton/Largest strain' allows in one step"
                                    : "turned inside out")
       << " near (" << bodies[body].points[outcome.bad_point].position()
       << ") m of its grid; a smaller 'Time/Time step' or 'Mesh/Cell size' may help";
  return text.str();
}

void World::heed_laws(const std::vector<StressOutcome> &stress, StepOutcome &outcome) const
{
  unsigned int first = 0;
  for (unsigned int b = 0; b < stress.size(); ++b)
    if (stress[b].share < stress[first].share)
      first = b;
  if (stress.empty() || stress[first].share >= 1.)
    return;
  outcome.accepted = false;
  outcome.law_asks = true;
  // A little shorter than asked for, so that the next attempt is not refused by rounding.
  outcome.share = 0.95 * stress[first].share;
  std::ostringstream text;
  text << "the law of body '" << bodies[first].name << "', '" << bodies[first].law->title()
       << "', allows no more than " << stress[first].share << " of this step";
  outcome.reason = text.str();
}

std::vector<double> end_gaps(const World &world,
                             const std::vector<Eigen::VectorXd> &increment,
                             const std::vector<WallMotion<2>> &motion,
                             const double dt)
{
  const auto &rows = world.contact.contact_rows();
  const unsigned int components = world.contact.n_components();
  std::vector<Eigen::VectorXd> rate(increment.size());
  for (unsigned int b = 0; b < increment.size(); ++b)
    rate[b] = increment[b] / dt;
  const std::vector<double> w = world.contact.relative_velocity(world.bodies, rate);
  std::vector<double> gap(rows.size());
  const std::optional<CellMotion> cell = world.cell_motion(motion);
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    gap[r] = rows[r].gap + dt * w[r * components];
    if (cell)
      gap[r] += dt * (cell->gradient * rows[r].branch) * rows[r].normal;
    if (rows[r].obstacle)
      gap[r] -= dt * rows[r].partner_velocity * rows[r].normal;
    else if (rows[r].partner == ContactRow<2>::none)
      gap[r] -= dt * motion[rows[r].wall].velocity;
  }
  return gap;
}

void World::note_contacts(const std::vector<Eigen::VectorXd> &increment,
                          const std::vector<WallMotion<2>> &motion,
                          const double dt)
{
  constexpr double near_limit = 1. - 1e-6; // of friction: solvers have tolerances
  const auto &rows = contact.contact_rows();
  const unsigned int components = contact.n_components();
  const std::vector<double> gaps = end_gaps(*this, increment, motion, dt), &P = contact.impulses();
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const double closing = P[r * components] + dt * rows[r].pull;
    const bool slides = components > 1 && closing > 0. && rows[r].friction > 0. &&
                        std::abs(P[r * components + 1]) >= near_limit * rows[r].friction * closing;
    adhesion.note(rows[r].key, rows[r].gap, {gaps[r], closing > 0., slides, dt});
  }
  adhesion.finish_step();
}

namespace
{
/// Impulses felt by the walls and the work done at the contacts during the step.
void account_contacts(World &world,
                      const double dt,
                      const std::vector<Eigen::VectorXd> &rate,
                      const std::vector<WallMotion<2>> &motion)
{
  std::vector<dealii::Tensor<1, 2>> force_before;
  for (unsigned int w = 0; w < world.walls.size(); ++w)
  {
    force_before.push_back(world.walls[w].force);
    world.walls[w].force = 0.;
    world.walls[w].speed = motion[w].rate;
    world.walls[w].slide_speed = motion[w].slide;
  }
  for (Obstacle &obstacle : world.obstacles)
    obstacle.arrive();
  const std::optional<CellMotion> cell = world.cell_motion(motion);
  dealii::Tensor<2, 2> virial;
  // The acceleration of (3.15) holds the contact forces at the start of the step: they act for its first
  // half, so what a wall gives is the mean of both ends, and the impulses of this step are half of the force
  // at its end.
  const bool half = world.settings.scheme.stored_acceleration;
  // From balance to balance forces change steadily: their work is that of the mean of both ends.
  const bool balanced = !world.settings.scheme.inertia;
  const auto give = [&](Wall &wall, const dealii::Tensor<1, 2> &given)
  {
    wall.give(given, dt);
    world.balance.wall_impulse += given;
    world.balance.wall_work += given * (balanced ? wall.velocity() : wall.prescribed_velocity());
  };
  if (half)
    for (Wall &wall : world.walls)
    {
      give(wall, 0.5 * dt * wall.carried);
      wall.carried = 0.;
    }
  // What the dents take is not lost.
  const double dents = world.contact.subgrid_energy(world.bodies, world.subgrid(), dt);
  if (!balanced)
    world.balance.contact_loss -= dents - world.balance.subgrid_energy;
  world.balance.subgrid_energy = dents;
  const auto &rows = world.contact.contact_rows();
  const unsigned int components = world.contact.n_components();
  const std::vector<double> &P = world.contact.impulses();
  const std::vector<double> w =
      rows.empty() ? std::vector<double>() : world.contact.relative_velocity(world.bodies, rate);
  for (unsigned int r = 0; r < rows.size(); ++r)
    for (unsigned int c = 0; c < components; ++c)
    {
      const double impulse = P[r * components + c];
      if (impulse == 0. && rows[r].pull == 0.)
        continue;
      double relative = w[r * components + c];
      double acting = impulse;
      if (half || balanced)
      {
        const auto before = world.contact.memory().find(rows[r].key);
        const double old = before == world.contact.memory().end() ? 0.
                           : half                                 ? before->second[c]
                                  : before->second[c] * dt / world.contact.memory_step;
        acting = (half ? 1. : 0.5) * (impulse + old);
      }
      if (rows[r].obstacle)
      {
        const dealii::Tensor<1, 2> given = impulse * rows[r].direction(c);
        world.obstacles[rows[r].wall - world.walls.size()].give(given, rows[r].place, dt);
        world.balance.wall_impulse += given;
        const double speed = rows[r].partner_velocity * rows[r].direction(c);
        world.balance.wall_work += acting * speed;
        relative -= speed;
      }
      else if (rows[r].wall != ContactRow<2>::none)
      {
        Wall &wall = world.walls[rows[r].wall];
        const dealii::Tensor<1, 2> given = impulse * rows[r].direction(c);
        give(wall, given);
        if (half)
          wall.carried += 2. / dt * given;
        // Slabs move in relative_velocity() already, planes do not.
        const WallMotion<2> &moves = motion[rows[r].wall];
        relative -= ((rows[r].partner == ContactRow<2>::none ? 0. : -moves.velocity) + moves.rate) *
                    (wall.normal() * rows[r].direction(c));
        if (rows[r].partner == ContactRow<2>::none && moves.slide != 0.)
          relative -= moves.slide * (moves.tangent() * rows[r].direction(c));
      }
      else if (rows[r].partner != ContactRow<2>::none && world.bodies[rows[r].partner].driven)
      {
        const dealii::Tensor<1, 2> given = impulse * rows[r].direction(c);
        world.balance.wall_impulse += given;
        world.balance.wall_work += given * world.bodies[rows[r].partner].drive;
      }
      if (cell)
      {
        virial += impulse / dt * outer_product(rows[r].direction(c), rows[r].branch);
        relative += cell->gradient * rows[r].branch * rows[r].direction(c);
      }
      if (c == 0 && rows[r].pull > 0.)
      {
        const double work = -(half ? 2. : 1.) * rows[r].pull * dt * relative;
        world.balance.adhesion_work += work;
        if (!balanced)
          world.balance.contact_loss += work;
      }
      // From balance to balance normal forces do no work: gaps are closed at both ends. What rows that have
      // moved in between would say is rounding in a smooth step, and meaningless where grains rearrange.
      if (c > 0 || !balanced)
        world.balance.contact_loss -= acting * relative;
    }
  if (cell)
  {
    load_sides(world.walls, cell->cell, virial);
    for (const Wall &wall : world.walls)
      if (wall.repeats())
        world.balance.wall_work -=
            dt * (wall.force * (balanced ? wall.velocity() : wall.prescribed_velocity()));
  }
  if (balanced)
    for (unsigned int w = 0; w < world.walls.size(); ++w)
    {
      const Wall &wall = world.walls[w];
      world.balance.wall_work +=
          0.5 * dt * wall.speed * (wall.force - force_before[w]) * wall.description.normal;
      if (wall.slide_speed != 0.)
        world.balance.wall_work +=
            0.5 * dt * wall.slide_speed * (wall.force - force_before[w]) * wall.tangent();
    }
  for (const FreeWall<2> &free : world.contact.free_walls.list)
    account_free_wall(world, free, free.slides() ? motion[free.wall].slide : motion[free.wall].rate, dt,
                      !half && world.settings.scheme.implicit);
}

/// Gives the points what the step has come to.
void keep_stress(Body<2> &body)
{
  const unsigned int n_history = body.law->n_history();
  for (std::size_t p = 0; p < body.points.size(); ++p)
  {
    auto point = body.points[p];
    point.stress() = body.step.stress[p];
    if (n_history > 0)
      std::copy_n(&body.step.history[p * n_history], n_history, point.history());
  }
}
} // namespace

void accept_step(World &world,
                 const StepPlan &plan,
                 std::vector<Eigen::VectorXd> &end_velocity,
                 const std::vector<Eigen::VectorXd> &increment,
                 const std::vector<Eigen::VectorXd> &rate,
                 const std::vector<WallMotion<2>> &motion,
                 const std::vector<Eigen::VectorXd> &external)
{
  const double dt = plan.dt;
  account_contacts(world, dt, rate, motion);
  if (world.adhesion.remembers())
    world.note_contacts(increment, motion, dt);
  const bool half = world.settings.scheme.stored_acceleration;
  dealii::Tensor<1, 2> load;
  for (Body<2> &body : world.bodies)
    if (body.driven)
    {
      body.translate(dt * body.drive);
      move_boundary(body);
    }
    else if (external[body.index].size() > 0)
    {
      const Eigen::VectorXd &force = external[body.index];
      world.balance.body_force_work += force.dot(rate[body.index]) * dt;
      for (unsigned int i = 0; i < body.field.n_independent(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          load[d] += force[2 * i + d];
    }
  std::vector<double> law_loss(world.bodies.size(), 0.);
  const std::optional<CellMotion> cell = world.cell_motion(motion);
  std::vector<dealii::Point<2>> centers;
  if (cell && cell->deforms())
    for (const Body<2> &body : world.bodies)
      centers.push_back(body.center());
  world.for_moving_bodies(
      [&](Body<2> &body)
      {
        Eigen::VectorXd &v = end_velocity[body.index];
        if (half)
          // (3.15), which is (3.16) as long as no position has been repaired.
          body.acceleration = 2. / dt * (v - body.velocity) - body.acceleration;
        body.displacement += increment[body.index];
        if (cell && cell->deforms())
          body.translate(dt * cell->velocity(centers[body.index]));
        if (body.velocity.size() > 0)
          std::swap(body.velocity, v);
        move_boundary(body);
        keep_stress(body);
        if (body.law->n_history() > 0)
          for (unsigned int p = 0; p < body.points.size(); ++p)
            law_loss[body.index] += body.step.dissipation[p] * body.step.volume[p];
      });
  for (const double loss : law_loss)
    world.balance.law_loss += loss;
  if (cell && world.settings.scheme.inertia)
    world.measure_against_cell(*cell, dt);
  world.balance.body_force_impulse += half ? 0.5 * dt * (load + world.balance.carried_load) : dt * load;
  world.balance.carried_load = load;
  for (unsigned int w = 0; w < world.walls.size(); ++w)
  {
    world.walls[w].travel += dt * motion[w].velocity;
    if (world.walls[w].repeats())
      world.walls[w].offset = cell->offset_after(dt);
  }
  if (!plan.held)
    world.time += dt;
  world.contact.remember(dt);
}
} // namespace softgrain::mpm
