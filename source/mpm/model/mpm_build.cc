// SPDX-License-Identifier: LGPL-2.1-or-later
// How MpmModel is built from a scene and its settings.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/linear/counting_solver.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/body/refinement.h>
#include <softgrain/mpm/contact/contact_geometry_kind.h>
#include <softgrain/mpm/model/long_steps.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/scene/motion_at_start.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
constexpr double touching = 1e-3; ///< gap up to which surfaces touch for adhesion [cells]
}

MpmModel::MpmModel(const Scene<2> &scene,
                   const Settings &settings,
                   std::vector<std::shared_ptr<const constitutive::Law<2>>> laws)
    : timer(std::make_unique<dealii::TimerOutput>(
          std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times))
{
  problem.scene = scene;
  problem.settings = settings;
  moved_by_more = moved_by_more_than_walls(scene);
  work.timer = timer.get();
  build(std::move(laws));
}

namespace
{
/// Bodies that begin outside of the mesh: what the mesh would have to hold is said at once, of all of them.
void check_mesh_holds(const std::vector<BodyDescription<2>> &bodies, const Lattice<2> &lattice)
{
  dealii::Point<2> low, high, end;
  std::string outside;
  for (const BodyDescription<2> &body : bodies)
  {
    const auto box = body.shape->bounding_box();
    for (unsigned int d = 0; d < 2; ++d)
    {
      end[d] = lattice.lower()[d] + lattice.n_cells()[d] * lattice.cell_size();
      low[d] = &body == &bodies.front() ? box.first[d] : std::min(low[d], box.first[d]);
      high[d] = &body == &bodies.front() ? box.second[d] : std::max(high[d], box.second[d]);
      const double seen = 1e-6 * lattice.cell_size();
      if (outside.empty() && (box.first[d] < lattice.lower()[d] - seen || box.second[d] > end[d] + seen))
        outside = body.name;
    }
  }
  if (outside.empty())
    return;
  std::ostringstream message;
  message << "'Bodies/" << outside << "' lies outside of the background mesh: bodies lie between (" << low
          << ") and (" << high << ") m, the mesh between 'Mesh/Lower' = (" << lattice.lower()
          << ") and 'Mesh/Upper' = (" << end
          << ") m; it must hold them, with a cell to spare and room for their ways";
  throw InputError(message.str());
}
} // namespace

void MpmModel::build(std::vector<std::shared_ptr<const constitutive::Law<2>>> laws)
{
  const Settings &settings = problem.settings;
  problem.lattice =
      std::make_unique<Lattice<2>>(settings.mesh_lower, settings.mesh_upper, settings.finest_cell());
  problem.shape = create_shape_function(settings.shape);
  PointNeeds needs;
  needs.velocity = !at_rest();
  needs.affine = settings.affine_transfer;
  for (const auto &law : laws)
  {
    needs.volume = needs.volume || law->kinematics() == constitutive::Kinematics::small_strain;
    needs.n_history = std::max(needs.n_history, law->n_history());
  }
  state.points = std::make_unique<PointStore<2>>(*problem.lattice, PointLayout<2>(needs));
  const BuildContext context{*problem.lattice, *problem.shape, settings, *state.points};
  std::vector<BodyDescription<2>> descriptions = problem.scene.bodies;
  check_mesh_holds(descriptions, *problem.lattice);
  const LevelsOfScene levels = refine_near_contact(problem.scene, settings, *problem.lattice);
  state.bodies.reserve(descriptions.size() + problem.scene.walls.size());
  for (const BodyDescription<2> &body : descriptions)
    state.bodies.push_back(make_body(body, state.bodies.size(), laws[body.material],
                                     problem.scene.materials[body.material].density, context,
                                     levels[state.bodies.size()]));
  for (Body<2> &body : state.bodies)
  {
    body.loads = problem.scene.loads;
    if (const auto own = body_force(descriptions[body.index].body_force))
      body.loads.add(own);
  }
  problem.pairs = ContactPairs(problem.scene);
  if (problem.pairs.adhere())
    state.adhesion = Adhesion(problem.scene.contact_law, touching * settings.finest_cell());
  state.walls = make_walls(problem.scene);
  state.obstacles = make_obstacles(problem.scene);
  for (unsigned int w = 0; w < state.walls.size(); ++w)
    if (state.walls[w].description.type == WallDescription<2>::Type::material_points)
    {
      state.walls[w].body = state.bodies.size();
      descriptions.push_back(wall_slab(state.walls[w].description, context));
      state.bodies.push_back(make_body(descriptions.back(), state.walls[w].body, laws[0],
                                       problem.scene.materials[0].density, context));
      state.bodies.back().rigid.wall = w;
    }
  problem.geometry = Registry<ContactGeometryKind>::instance()
                         .create(settings.contact_geometry)
                         ->create(*problem.shape, settings);
  share_out_bodies(descriptions);
  fill_bodies(descriptions);
  work.trial.resize(state.bodies.size());
  work.matrices.resize(state.bodies.size());
  work.solvers.resize(state.bodies.size());
  for (const Body<2> &body : state.bodies)
    prepare_solver(body);
  choose_for_long_steps(wanted_step(), cfl_step(), problem.settings);
  settings.scheme.check_step(wanted_step(), cfl_step());
  state.balance.momentum.initial = momentum();
  initial_energy = energies().kinetic;
  update_momentum_scale();
}

bool MpmModel::needs_matrix(const Body<2> &body) const
{
  return problem.settings.scheme.solves_equations() && !body.rigid.driven && work.share.mine(body.index);
}

void MpmModel::lay_out_matrix(const Body<2> &body)
{
  if (needs_matrix(body))
    lay_out_stiffness(body.field, work.matrices[body.index], problem.settings.meets_by_rays());
}

void MpmModel::prepare_solver(const Body<2> &body)
{
  if (!needs_matrix(body))
    return;
  const Settings &settings = problem.settings;
  const bool condensed = settings.coupling == ContactCoupling::condensed &&
                         state.bodies.size() + problem.scene.walls.size() + state.obstacles.size() > 1;
  SystemMatrix &matrix = work.matrices[body.index];
  lay_out_matrix(body);
  std::unique_ptr<LinearSolver> solver = create_linear_solver(settings.linear_solver, matrix, 2, condensed);
  if (condensed && at_rest())
    solver = std::make_unique<CountingSolver>(std::move(solver));
  work.solvers[body.index] = std::make_unique<RankOneSolver>(std::move(solver));
}

void MpmModel::cover_points()
{
  // Where grids are laid anew, points may come to any cell.
  if (problem.settings.grid_update != GridUpdate::never)
    return state.points->cover_all();
  // Points are within outlines; a cell more makes up for rounding.
  const Lattice<2>::Index &n = problem.lattice->n_cells();
  Lattice<2>::Index first = n, last{};
  for (const Body<2> &body : state.bodies)
    if (work.share.holds(body.index))
      for (const dealii::Point<2> &x : body.boundary.grid_position)
        for (unsigned int d = 0; d < 2; ++d)
        {
          const int c = problem.lattice->cell_of(x)[d];
          first[d] = std::min(first[d], std::max(0, c - 1));
          last[d] = std::max(last[d], std::min(n[d] - 1, c + 1));
        }
  if (first[0] > last[0]) // no body
    first = last = {};
  state.points->cover(first, last);
}

void MpmModel::fill_bodies(const std::vector<BodyDescription<2>> &descriptions)
{
  const BuildContext context{*problem.lattice, *problem.shape, problem.settings, *state.points};
  work.share.exchange.together(
      [&]()
      {
        cover_points();
        for (Body<2> &body : state.bodies)
          if (work.share.holds(body.index))
            fill_body(body, descriptions[body.index], context);
        state.order_points();
        for (Body<2> &body : state.bodies)
          if (work.share.holds(body.index))
            start_body(body, descriptions[body.index], context);
      });
  for (const Body<2> &body : state.bodies)
    work.drive.push_back(body.rigid.drive);
  share_grids(all_bodies());
}
} // namespace softgrain::mpm
