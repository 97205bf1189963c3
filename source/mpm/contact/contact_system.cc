// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/problem_io.h>
#include <softgrain/mpm/contact/contact_system.h>

#include <algorithm>
#include <variant>

namespace softgrain::mpm
{
template <int dim>
struct ContactSystem<dim>::Operator
{
  std::variant<contact::BlockDelassus, contact::MassDelassus> kind;
};

template <int dim>
void ContactSystem<dim>::reinit(std::vector<ContactRow<dim>> new_rows,
                                const BodyShare &share,
                                const bool everywhere,
                                const std::vector<Body<dim>> &bodies,
                                const double dt,
                                const ContactMemory<dim> &before)
{
  const double scale = before.step == 0. ? 1. : dt / before.step;
  rows = std::move(new_rows);
  const bool friction =
      std::any_of(rows.begin(), rows.end(), [](const auto &row) { return row.law.friction > 0.; });
  const unsigned int components = friction ? dim : 1;
  problem.n_components = components;
  problem.friction.clear();
  free_walls.reinit(rows, components);
  if (friction)
  {
    for (const auto &row : rows)
      problem.friction.push_back(row.law.friction);
    problem.friction.resize(rows.size() + free_walls.n_stops(), 0.);
  }
  problem.cohesion.clear();
  if (std::any_of(rows.begin(), rows.end(), [](const auto &row) { return row.law.pull > 0.; }))
  {
    for (const auto &row : rows)
      problem.cohesion.push_back(dt * row.law.pull);
    problem.cohesion.resize(rows.size() + free_walls.n_stops(), 0.);
  }
  list_components(bodies);
  body_rows.resize(bodies.size());
  rows_here.assign(bodies.size(), 1);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    rows_here[b] = everywhere || share.mine(b);
  pushes.clear();
  parallel_for(bodies.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (rows_here[b])
                     body_rows[b].reinit(bodies[b], rows, body_components[b], components);
               });
  impulse.assign((rows.size() + free_walls.n_stops()) * components, 0.);
  velocity.assign(impulse.size(), 0.);
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const auto old = before.impulses.find(rows[r].key);
    if (old != before.impulses.end())
      for (unsigned int c = 0; c < components; ++c)
        impulse[r * components + c] = scale * old->second[c];
  }
  free_walls.move(impulse);
  color_pairs(bodies);
}

template <int dim>
ContactMemory<dim> ContactSystem<dim>::memory(const double dt) const
{
  ContactMemory<dim> now;
  now.step = dt;
  now.impulses.reserve(rows.size());
  for (unsigned int r = 0; r < rows.size(); ++r)
    if (carries_force(*this, r))
    {
      std::array<double, dim> value{};
      for (unsigned int c = 0; c < n_components(); ++c)
        value[c] = impulse[r * n_components() + c];
      now.impulses[rows[r].key] = value;
    }
  return now;
}

template <int dim>
std::vector<double> ContactSystem<dim>::relative_velocity(const BodyShare &share,
                                                          const std::vector<Body<dim>> &bodies,
                                                          const std::vector<dealii::Tensor<1, dim>> &drive,
                                                          const Velocities &nodal) const
{
  std::vector<double> w(rows.size() * n_components(), 0.), of_bodies(component_start.back());
  share.for_mine(
      bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        if (!body_components[b].empty())
          Eigen::Map<Eigen::VectorXd>(&of_bodies[component_start[b]], body_components[b].size()) =
              body_rows[b].velocities(nodal(b));
      },
      [&](BodyShare::Message &message)
      {
        for (unsigned int b = 0; b < bodies.size(); ++b)
          if (!body_components[b].empty())
            message.add(b, &of_bodies[component_start[b]], body_components[b].size());
      });
  for (unsigned int b = 0; b < bodies.size(); ++b)
    for (unsigned int k = 0; k < body_components[b].size(); ++k)
      w[body_components[b][k]] += of_bodies[component_start[b] + k];
  for (const unsigned int r : rows_at_driven)
    for (unsigned int c = 0; c < n_components(); ++c)
      w[r * n_components() + c] -= drive[rows[r].partner] * direction_of(rows[r], c);
  return w;
}

template <int dim>
void ContactSystem<dim>::add_impulses(const unsigned int b, Eigen::VectorXd &nodal) const
{
  if (body_components.size() <= b || body_components[b].empty())
    return;
  if (!pushes.empty())
  {
    nodal += pushes[b];
    return;
  }
  Eigen::VectorXd own(body_components[b].size());
  for (unsigned int k = 0; k < own.size(); ++k)
    own[k] = impulse[body_components[b][k]];
  body_rows[b].add_impulses(own, nodal);
}

template <int dim>
void ContactSystem<dim>::keep_pushes()
{
  std::vector<Eigen::VectorXd> now(body_rows.size());
  pushes.clear();
  parallel_for(now.size(), 16,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (knows_rows_of(b))
                   {
                     now[b].setZero(body_rows[b].n_dofs());
                     add_impulses(b, now[b]);
                   }
               });
  pushes = std::move(now);
}

template <int dim>
void ContactSystem<dim>::condense(const BodyShare &share,
                                  const std::vector<Body<dim>> &bodies,
                                  std::vector<std::unique_ptr<RankOneSolver>> &solvers)
{
  contact::BlockDelassus W;
  if (delassus.use_count() == 1 && std::holds_alternative<contact::BlockDelassus>(delassus->kind))
    W = std::move(std::get<contact::BlockDelassus>(delassus->kind)); // its memory
  W.reinit(rows.size() + free_walls.n_stops(), n_components());
  constexpr unsigned int none = ContactRow<dim>::none;
  std::vector<unsigned int> block_of(bodies.size(), none);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    if (!body_components[b].empty())
    {
      block_of[b] = W.n_blocks();
      W.add_room(body_components[b]);
    }
  share.for_mine(
      bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        if (block_of[b] == none)
          return;
        Eigen::MatrixXd block;
        body_rows[b].condense(*solvers[b], block);
        W.set_block(block_of[b], block);
      },
      [&](BodyShare::Message &message)
      {
        for (unsigned int b = 0; b < bodies.size(); ++b)
          if (block_of[b] != none)
            message.add(b, W.block_values(block_of[b]),
                        std::size_t(body_components[b].size()) * body_components[b].size());
      });
  free_walls.add_blocks(W);
  delassus = std::make_shared<Operator>(Operator{std::move(W)});
}

template <int dim>
void take_back_softness(const ContactSystem<dim> &system, const double dt, std::vector<double> &free_velocity)
{
  const auto &rows = system.contact_rows();
  const unsigned int n = system.n_components();
  for (unsigned int k = 0; k < rows.size() * n; ++k)
    free_velocity[k] -= rows[k / n].law.softness / (dt * dt) * system.impulses()[k];
}

template <int dim>
void ContactSystem<dim>::lump(const std::vector<Body<dim>> &bodies, const double dt)
{
  std::vector<unsigned int> offset(bodies.size() + 1, 0);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    offset[b + 1] = offset[b] + bodies[b].field.n_dofs();
  std::vector<double> inverse_mass(offset.back(), 0.);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    if (!bodies[b].rigid.driven)
      for (unsigned int i = 0; i < bodies[b].field.n_dofs(); ++i)
        inverse_mass[offset[b] + i] = 1. / bodies[b].nodes.mass[i / dim];

  std::vector<std::vector<std::pair<unsigned int, double>>> list(rows.size() * n_components());
  for (unsigned int b = 0; b < bodies.size(); ++b)
  {
    const LinearSolver::Rows &of_body = body_rows[b].transposed();
    for (unsigned int k = 0; k < body_components[b].size(); ++k)
      for (LinearSolver::Rows::InnerIterator entry(of_body, k); entry; ++entry)
        list[body_components[b][k]].emplace_back(offset[b] + entry.row(), entry.value());
  }
  for (unsigned int k = 0; k < free_walls.list.size(); ++k)
  {
    for (const auto &entry : free_walls.entries(k))
      list[entry.component].emplace_back(inverse_mass.size(), -entry.factor);
    inverse_mass.push_back(1. / free_walls.list[k].mass);
  }
  // A mass of its own that gives way to a component alone.
  for (unsigned int k = 0; k < list.size(); ++k)
    if (const double softness = rows[k / n_components()].law.softness; softness > 0.)
    {
      list[k].emplace_back(inverse_mass.size(), 1.);
      inverse_mass.push_back(softness / (dt * dt));
    }
  std::vector<unsigned int> start(1, 0), dofs;
  std::vector<double> weights;
  for (const auto &row : list)
  {
    for (const auto &[dof, weight] : row)
    {
      dofs.push_back(dof);
      weights.push_back(weight);
    }
    start.push_back(dofs.size());
  }
  delassus = std::make_shared<Operator>(Operator{contact::MassDelassus(
      n_components(), std::move(start), std::move(dofs), std::move(weights), std::move(inverse_mass))});
}

template <int dim>
contact::SolverReport ContactSystem<dim>::solve(std::vector<double> free_velocity,
                                                const contact::SolverSettings &given_settings,
                                                const bool relative)
{
  contact::SolverSettings settings = given_settings;
  free_walls.add_stops(free_velocity);
  const double factor = free_walls.tolerance_factor(free_velocity);
  settings.tolerance *= factor;
  return std::visit(
      [&](auto &W)
      {
        if (relative)
        {
          // free velocity = (velocity with the present impulses) - W (present impulses)
          problem.free_velocity.assign(free_velocity.size(), 0.);
          std::vector<double> effect;
          contact::compute_velocities(W, problem, impulse, effect);
          for (unsigned int k = 0; k < effect.size(); ++k)
            free_velocity[k] -= effect[k];
        }
        problem.free_velocity = std::move(free_velocity);
        last_start = impulse;
        contact::SolverReport report = contact::solve(W, problem, settings, impulse, velocity);
        report.residual /= factor;
        plain_solves += report.fell_back;
        free_walls.move(impulse);
        keep_pushes();
        return report;
      },
      delassus->kind);
}

template <int dim>
void ContactSystem<dim>::save_problem(const std::string &file,
                                      const std::string &description,
                                      const contact::SolverSettings &settings) const
{
  std::visit([&](const auto &W)
             { contact::save_problem(file, W, problem, settings, last_start, description); },
             delassus->kind);
}

template void take_back_softness<2>(const ContactSystem<2> &, double, std::vector<double> &);
template void take_back_softness<3>(const ContactSystem<3> &, double, std::vector<double> &);
template class ContactSystem<2>;
template class ContactSystem<3>;
} // namespace softgrain::mpm
