// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_partner.h>
#include <softgrain/mpm/stepping/account_contacts.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/driven_work.h>
#include <softgrain/mpm/stepping/plane_partners.h>
#include <softgrain/mpm/stepping/pressed_walls.h>

#include <optional>
#include <vector>

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
  void go_on() const { partners.go_on(); }

private:
  void book_row(const ContactWork &contact, unsigned int row, unsigned int component);

  State &state;
  const Workspace &work;
  const FoundStep &step;
  const double dt;
  const PlanePartners partners;
  const std::optional<CellMotion<2>> cell;
  dealii::Tensor<2, 2> virial;
};

ContactAccounts::ContactAccounts(State &state, const Workspace &work, const FoundStep &step)
    : state(state)
    , work(work)
    , step(step)
    , dt(step.plan.dt)
    , partners(state, work, step)
    , cell(state.cell_motion(step.motion))
{
}

void ContactAccounts::book_row(const ContactWork &contact, const unsigned int r, const unsigned int c)
{
  const ContactRow<2> &row = work.contact.contact_rows()[r];
  const Vector direction = direction_of(row, c);
  const double impulse = work.contact.impulses()[r * work.contact.n_components() + c],
               acting = contact.acting(r, c);
  if (RigidPartner<2> *const partner = partners.of(row))
  {
    const PartnerImpulse<2> given{
        direction, impulse, acting, row.place, row.velocity_of_place.value_or(Vector()), dt};
    partner->take(given);
    state.balance.momentum.of_walls += given.given();
  }
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
  for_sides(state.walls, [this](Wall<2> &side)
            { side.book.work -= dt * (side.book.force * working_velocity(side, step.balanced)); });
}

void ContactAccounts::book_means()
{
  std::vector<DrivenWork> driven;
  partners.book_means(driven);
  if (const double share = give_kinks(step.kinks, driven); share > 0.)
    state.balance.contact_loss += share * step.kinks.of_slides;
  state.balance.losses.add(loss::regularisation, partners.book_loads());
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
  accounts.go_on();
  for (const FreeWall<2> &free : work.contact.free_walls.list)
    account_free_wall(problem, state, free,
                      free.slides() ? step.motion[free.wall].slide : step.motion[free.wall].rate,
                      step.plan.dt);
}
} // namespace softgrain::mpm
