// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/account_contacts.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/driven_work.h>
#include <softgrain/mpm/stepping/pressed_walls.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// The books of the contacts of one step.
class ContactAccounts
{
public:
  /// Walls and obstacles move, and have not felt anything yet.
  ContactAccounts(State &state, const Workspace &work, const FoundStep &step);

  void book_rows();
  void load_sides_of_cell();
  /// From balance to balance: what obstacles, walls and contacts did beside the work of the forces at the
  /// end.
  void book_means();

private:
  void book_row(const ContactWork &contact, unsigned int row, unsigned int component);
  void book_partner(const ContactRow<2> &row, const Vector &direction, double impulse, double acting);
  void give(Wall<2> &wall, const Vector &given);
  /// The part of the velocity of a wall with which it does work, not its load [m/s].
  Vector working_velocity(const Wall<2> &wall) const
  {
    return step.balanced ? wall.velocity() : prescribed_velocity_of(wall);
  }
  void book_wall(unsigned int w, std::vector<DrivenWork> &driven);

  State &state;
  const Workspace &work;
  const FoundStep &step;
  const double dt;
  std::vector<Vector> force_before;                   ///< on walls
  std::vector<std::pair<Vector, double>> felt_before; ///< by obstacles: force and torque
  const std::optional<CellMotion> cell;
  dealii::Tensor<2, 2> virial;
};

ContactAccounts::ContactAccounts(State &state, const Workspace &work, const FoundStep &step)
    : state(state), work(work), step(step), dt(step.plan.dt), cell(state.cell_motion(step.motion))
{
  for (unsigned int w = 0; w < state.walls.size(); ++w)
  {
    force_before.push_back(state.walls[w].book.force);
    state.walls[w].book.force = 0.;
    state.walls[w].speed = step.motion[w].rate;
    state.walls[w].slide_speed = step.motion[w].slide;
  }
  for (Obstacle<2> &obstacle : state.obstacles)
  {
    felt_before.emplace_back(obstacle.force, obstacle.torque);
    obstacle.arrive();
  }
}

void ContactAccounts::give(Wall<2> &wall, const Vector &given)
{
  wall.book.give(given, dt);
  state.balance.momentum.of_walls += given;
  wall.book.work += given * working_velocity(wall);
}

void ContactAccounts::book_partner(const ContactRow<2> &row,
                                   const Vector &direction,
                                   const double impulse,
                                   const double acting)
{
  const Vector given = impulse * direction;
  if (row.obstacle)
  {
    Obstacle<2> &obstacle = state.obstacles[row.wall - state.walls.size()];
    obstacle.give(given, row.place, dt);
    state.balance.momentum.of_walls += given;
    if (!step.balanced)
      obstacle.work += acting * (row.partner_velocity * direction);
  }
  else if (row.wall != ContactRow<2>::none)
    give(state.walls[row.wall], given);
  else if (row.partner != ContactRow<2>::none && state.bodies[row.partner].driven)
  {
    state.balance.momentum.of_walls += given;
    state.balance.driven_work += acting * (direction * work.drive[row.partner]);
  }
}

void ContactAccounts::book_row(const ContactWork &contact, const unsigned int r, const unsigned int c)
{
  const ContactRow<2> &row = work.contact.contact_rows()[r];
  const Vector direction = direction_of(row, c);
  const double impulse = work.contact.impulses()[r * work.contact.n_components() + c],
               acting = contact.acting(r, c);
  book_partner(row, direction, impulse, acting);
  if (cell)
    virial += impulse / dt * outer_product(direction, row.cell.branch);
  if (c == 0 && !step.balanced)
  {
    const double pulled = contact.adhesion_work(r);
    state.balance.adhesion_work += pulled;
    state.balance.contact_loss += pulled - row.beyond.work;
  }
  // From balance to balance normal forces do no work: gaps are closed at both ends. What rows that have
  // moved in between would say is rounding in a smooth step, and meaningless where grains rearrange.
  if (c > 0 || !step.balanced)
    state.balance.contact_loss -= acting * contact.parting(r, c);
}

void ContactAccounts::book_rows()
{
  const ContactWork contact(state, work, dt, step.rate, step.motion, step.balanced);
  for (unsigned int r = 0; r < work.contact.contact_rows().size(); ++r)
    for (unsigned int c = 0; c < work.contact.n_components(); ++c)
      if (contact.acts(r, c))
        book_row(contact, r, c);
}

void ContactAccounts::load_sides_of_cell()
{
  if (!cell)
    return;
  load_sides(state.walls, cell->cell, virial);
  for (Wall<2> &wall : state.walls)
    if (is_side_of_cell(wall))
      wall.book.work -= dt * (wall.book.force * working_velocity(wall));
}

void ContactAccounts::book_wall(const unsigned int w, std::vector<DrivenWork> &driven)
{
  Wall<2> &wall = state.walls[w];
  double change = 0.5 * dt * wall.speed * (wall.book.force - force_before[w]) * wall.description.normal;
  if (wall.slide_speed != 0.)
    change += 0.5 * dt * wall.slide_speed * (wall.book.force - force_before[w]) * wall.tangent();
  wall.book.work += change;
  driven.push_back({&wall.book.work, std::abs(change)});
}

void ContactAccounts::book_means()
{
  std::vector<DrivenWork> driven;
  for (unsigned int o = 0; o < state.obstacles.size(); ++o)
    book_obstacle(state.obstacles[o], felt_before[o].first, felt_before[o].second, driven);
  for (unsigned int w = 0; w < state.walls.size(); ++w)
    book_wall(w, driven);
  if (const double share = give_kinks(step.kinks, driven); share > 0.)
    state.balance.contact_loss += share * step.kinks.of_slides;
}
} // namespace

void account_contacts(const Problem &problem, State &state, const Workspace &work, const FoundStep &step)
{
  ContactAccounts accounts(state, work, step);
  state.balance.subgrid_energy = step.dents;
  state.balance.adhesion_work += step.adhesion_work;
  accounts.book_rows();
  accounts.load_sides_of_cell();
  if (step.balanced)
    accounts.book_means();
  for (const FreeWall<2> &free : work.contact.free_walls.list)
    account_free_wall(problem, state, free,
                      free.slides() ? step.motion[free.wall].slide : step.motion[free.wall].rate,
                      step.plan.dt);
}
} // namespace softgrain::mpm
