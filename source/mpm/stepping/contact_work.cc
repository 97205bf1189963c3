// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/stepping/contact_work.h>
#include <softgrain/mpm/stepping/plane_partners.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/stored_energy.h>

#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
constexpr double allowed = 1e-3; ///< share of the energy of all bodies that contact may give in a step
/// Energy of such a strain is within the tolerance of the contact problem.
constexpr double floor_strain = 1e-6;
} // namespace

ContactWork::ContactWork(const State &state,
                         const Workspace &work,
                         const double dt,
                         const std::vector<Eigen::VectorXd> &rate,
                         const std::vector<WallMotion<2>> &motion,
                         const bool balanced)
    : state(state)
    , work(work)
    , dt(dt)
    , motion(motion)
    , cell(state.cell_motion(motion))
    , balanced(balanced)
    , components(work.contact.n_components())
{
  if (!work.contact.contact_rows().empty())
    relative = relative_velocity(state, work, rate);
}

bool ContactWork::acts(const unsigned int row, const unsigned int component) const
{
  return work.contact.impulses()[row * components + component] != 0. ||
         work.contact.contact_rows()[row].law.pull != 0.;
}

double ContactWork::acting(const unsigned int row, const unsigned int component) const
{
  const double impulse = work.contact.impulses()[row * components + component];
  if (!balanced)
    return impulse;
  const auto before = state.memory.impulses.find(work.contact.contact_rows()[row].key);
  const double old =
      before == state.memory.impulses.end() ? 0. : before->second[component] * dt / state.memory.step;
  return 0.5 * (impulse + old);
}

double ContactWork::parting(const unsigned int row, const unsigned int component) const
{
  const ContactRow<2> &of_row = work.contact.contact_rows()[row];
  double speed = parting_at_work(of_row, motion, component, relative[row * components + component]);
  if (cell)
    speed += cell->gradient * of_row.cell.branch * direction_of(of_row, component);
  return speed;
}

double ContactWork::adhesion_work(const unsigned int row) const
{
  const ContactRow<2> &of_row = work.contact.contact_rows()[row];
  return of_row.law.pull > 0. ? of_row.beyond.pull - of_row.law.pull * dt * parting(row, 0) : 0.;
}

ContactWork::Gift ContactWork::gift() const
{
  Gift gift;
  double most = 0.;
  for (unsigned int r = 0; r < work.contact.contact_rows().size(); ++r)
  {
    double given = work.contact.contact_rows()[r].beyond.work - adhesion_work(r);
    for (unsigned int c = 0; c < components; ++c)
      if (acts(r, c))
        given += acting(r, c) * parting(r, c);
    gift.energy += given;
    if (given > most)
    {
      most = given;
      gift.row = r;
    }
  }
  return gift;
}

template <int dim>
std::optional<double> energy_where_contact_gives(const std::vector<Body<dim>> &bodies,
                                                 const double given,
                                                 const std::function<double()> &stored)
{
  double kinetic = 0., floor = 0.;
  for (const Body<dim> &body : bodies)
    if (!body.rigid.driven)
    {
      kinetic += body.nodes.kinetic_energy();
      floor += floor_strain * floor_strain * body.material.law->young_modulus() * body.nodes.mass.sum() /
               body.material.density;
    }
  // Most steps end here.
  if (given <= allowed * kinetic + floor)
    return std::nullopt;
  const double held = kinetic + stored();
  return given <= allowed * held + floor ? std::nullopt : std::make_optional(held);
}

template std::optional<double>
energy_where_contact_gives(const std::vector<Body<2>> &, double, const std::function<double()> &);
template std::optional<double>
energy_where_contact_gives(const std::vector<Body<3>> &, double, const std::function<double()> &);

std::string why_contact_gives(const Problem &problem,
                              const State &state,
                              const Workspace &work,
                              const ContactWork &contact,
                              const std::vector<Eigen::VectorXd> &increment)
{
  const ContactWork::Gift gift = contact.gift();
  const std::optional<double> held = energy_where_contact_gives(
      state.bodies, gift.energy, [&] { return elastic_energy(state, work.share, &increment); });
  if (!held)
    return "";
  const ContactRow<2> &row = work.contact.contact_rows()[gift.row];
  std::ostringstream text;
  text << "contact would give the bodies " << short_number(gift.energy) << " J/m where they have "
       << short_number(*held) << " J/m, most of it where body '" << state.bodies[row.body].name << "' meets "
       << partner_in_words(state, row.wall, row.partner) << "' near (" << short_number(row.place[0]) << ", "
       << short_number(row.place[1]) << ") m, with a gap of "
       << short_number(row.gap / problem.lattice->cell_size()) << " cells at the start of the step";
  return text.str();
}

std::string why_contact_gives(const Problem &problem,
                              const State &state,
                              const Workspace &work,
                              const double dt,
                              const std::vector<WallMotion<2>> &motion,
                              const std::vector<Eigen::VectorXd> &increment)
{
  std::vector<Eigen::VectorXd> rate(increment.size());
  for (unsigned int b = 0; b < rate.size(); ++b)
    if (work.share.mine(b))
      rate[b] = increment[b] / dt;
  return why_contact_gives(problem, state, work, ContactWork(state, work, dt, rate, motion, false),
                           increment);
}
} // namespace softgrain::mpm
