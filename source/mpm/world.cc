// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/assembly.h>
#include <softgrain/mpm/body_builder.h>
#include <softgrain/mpm/world.h>

#include <algorithm>

namespace softgrain::mpm
{
std::vector<WallMotion<2>> World::wall_motion(const double dt) const
{
  std::vector<WallMotion<2>> motion;
  for (const Wall &wall : walls)
    // The middle of the step: exact for speeds linear in time.
    motion.push_back({wall.point(), wall.description.normal, wall.velocity.empty() ? 0. : wall.velocity[0]({time + 0.5 * dt}),
                      wall.description.friction, wall.body == ContactRow<2>::none});
  return motion;
}

std::vector<double> end_gaps(const World &world, const std::vector<Eigen::VectorXd> &increment, const std::vector<WallMotion<2>> &motion,
                             const double dt)
{
  const auto         &rows       = world.contact.contact_rows();
  const unsigned int  components = world.contact.n_components();
  std::vector<Eigen::VectorXd> rate(increment.size());
  for (unsigned int b = 0; b < increment.size(); ++b)
    rate[b] = increment[b] / dt;
  const std::vector<double> w = world.contact.relative_velocity(world.bodies, rate);
  std::vector<double>       gap(rows.size());
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    gap[r] = rows[r].gap + dt * w[r * components];
    if (rows[r].partner == ContactRow<2>::none)
      gap[r] -= dt * motion[rows[r].wall].velocity;
  }
  return gap;
}

namespace
{
/// Impulses felt by the walls and the work done at the contacts during the step.
void account_contacts(World &world, const double dt, const std::vector<Eigen::VectorXd> &rate, const std::vector<WallMotion<2>> &motion)
{
  // In newmark contact is a force at the end of the step: half of it acts in this step, through the impulse, the other half
  // in the next one, through the acceleration that is carried there.
  const bool   halves = world.settings.scheme.stored_acceleration;
  const double whole  = halves ? 2. : 1.;
  for (unsigned int w = 0; w < world.walls.size(); ++w)
  {
    Wall &wall = world.walls[w];
    wall.speed = motion[w].velocity;
    if (halves)
    {
      const dealii::Tensor<1, 2> carried = -0.5 * dt * wall.force;
      wall.impulse += carried;
      world.balance.wall_impulse += carried;
      world.balance.wall_work += carried * (wall.speed * wall.description.normal);
    }
    wall.force = 0.;
  }
  const auto                &rows       = world.contact.contact_rows();
  const unsigned int         components = world.contact.n_components();
  const std::vector<double> &P          = world.contact.impulses();
  const std::vector<double>  w          = rows.empty() ? std::vector<double>() : world.contact.relative_velocity(world.bodies, rate);
  for (unsigned int r = 0; r < rows.size(); ++r)
    for (unsigned int c = 0; c < components; ++c)
    {
      const double impulse = P[r * components + c];
      if (impulse == 0.)
        continue;
      double relative = w[r * components + c];
      if (rows[r].wall != ContactRow<2>::none)
      {
        Wall                       &wall  = world.walls[rows[r].wall];
        const dealii::Tensor<1, 2>  given = impulse * rows[r].direction(c);
        const dealii::Tensor<1, 2>  drive = wall.speed * wall.description.normal;
        wall.force -= whole * given / dt;
        wall.impulse += given;
        world.balance.wall_impulse += given;
        world.balance.wall_work += given * drive;
        // Slabs move in relative_velocity() already, planes do not.
        if (rows[r].partner == ContactRow<2>::none)
          relative -= drive * rows[r].direction(c);
      }
      else if (rows[r].partner != ContactRow<2>::none && world.bodies[rows[r].partner].driven)
      {
        const dealii::Tensor<1, 2> given = impulse * rows[r].direction(c);
        world.balance.wall_impulse += given;
        world.balance.wall_work += given * world.bodies[rows[r].partner].drive;
      }
      world.balance.contact_loss -= impulse * relative;
    }
}
} // namespace

void accept_step(World &world, const double dt, std::vector<Eigen::VectorXd> &end_velocity, const std::vector<Eigen::VectorXd> &increment,
                 const std::vector<Eigen::VectorXd> &rate, const std::vector<WallMotion<2>> &motion,
                 const std::vector<Eigen::VectorXd> &external)
{
  account_contacts(world, dt, rate, motion);
  for (unsigned int b = 0; b < world.bodies.size(); ++b)
  {
    Body<2> &body = world.bodies[b];
    if (body.driven)
    {
      for (unsigned int i = 0; i < body.field.n_independent(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          body.displacement[2 * i + d] += dt * body.drive[d];
      move_boundary(body);
      continue;
    }
    if (external[b].size() > 0)
    {
      world.balance.body_force_work += external[b].dot(rate[b]) * dt;
      for (unsigned int i = 0; i < body.field.n_independent(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          world.balance.body_force_impulse[d] += dt * external[b][2 * i + d];
    }
    if (world.settings.scheme.stored_acceleration)
      body.acceleration = 4. / (dt * dt) * increment[b] - 4. / dt * body.velocity - body.acceleration; // (3.16)
    body.displacement += increment[b];
    std::swap(body.velocity, end_velocity[b]);
    move_boundary(body);
    body.points.stress              = body.step.stress;
    body.points.out_of_plane_stress = body.step.out_of_plane_stress;
    std::swap(body.points.history, body.step.history);
    body.elastic_energy = stored_energy(body);
    for (unsigned int p = 0; p < body.points.size(); ++p)
      world.balance.law_loss += body.step.dissipation[p] * body.step.volume[p];
  }
  for (Wall &wall : world.walls)
    wall.travel += dt * wall.speed;
  world.time += dt;
  world.contact.remember();
}
} // namespace softgrain::mpm
