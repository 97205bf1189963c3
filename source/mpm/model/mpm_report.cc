// SPDX-License-Identifier: LGPL-2.1-or-later
// What MpmModel tells of itself: sums, energies, sizes, times.
#include <softgrain/geometry/shape.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/stepping/stored_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Strains, and velocities over that of waves, up to this are rounding.
constexpr double rounded_strain = 1e-12;
/// Strains up to this are within what Newton's method takes for balance without inertia, see
/// RayEquations::measure().
constexpr double unresolved_strain = 1e-8;
} // namespace

dealii::Tensor<1, 2> MpmModel::momentum() const
{
  dealii::Tensor<1, 2> sum;
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
      sum += body.nodes.momentum();
  return sum;
}

double MpmModel::momentum_error() const
{
  if (at_rest())
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.;
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
      sum += rounded_strain * problem.scene.bodies[body.index].shape->area() *
             std::sqrt(body.material.law->wave_modulus() * body.material.density);
  return state.balance.momentum.error(momentum(), sum);
}

double MpmModel::energy_of_rounding() const
{
  const double strain = at_rest() ? unresolved_strain : rounded_strain;
  double sum = 0.;
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven)
      sum += strain * strain * problem.scene.bodies[body.index].shape->area() *
             body.material.law->wave_modulus();
  return sum;
}

Energies MpmModel::energies() const
{
  Energies energies;
  if (!at_rest())
  {
    for (const Body<2> &body : state.bodies)
      if (!body.rigid.driven)
        energies.kinetic += body.nodes.kinetic_energy();
    for (const Wall<2> &wall : state.walls)
      energies.kinetic += kinetic_energy_of(wall);
  }
  energies.elastic = stored_energy(state, work.share);
  energies.dissipated = state.balance.dissipated();
  energies.external_work = state.external_work();
  return energies;
}

std::vector<std::pair<std::string, double>> MpmModel::works() const
{
  Workers workers;
  workers.loads = problem.scene.loads.names();
  for (const BodyDescription<2> &body : problem.scene.bodies)
    workers.driven_bodies = workers.driven_bodies || body.driven;
  for (const Body<2> &body : state.bodies)
  {
    workers.growth = workers.growth || (!body.rigid.driven && body.material.law->is_active());
  }
  if (std::any_of(state.bodies.begin(), state.bodies.end(),
                  [&](const Body<2> &body) { return body.loads.size() > problem.scene.loads.size(); }))
    workers.loads.push_back(name_of_body_force);
  workers.cell = state.repeats();
  workers.adhesion = problem.pairs.adhere();
  return columns_of_work(state.balance, state.walls, state.obstacles, workers);
}

std::size_t MpmModel::n_points() const
{
  std::size_t sum = 0;
  for (const Body<2> &body : state.bodies)
    sum += body.n_points;
  return sum;
}

std::size_t MpmModel::n_bodies() const
{
  return problem.scene.bodies.size();
}

SizeReport MpmModel::size_report() const
{
  const auto text = [](const double value, const std::string &unit)
  {
    std::ostringstream s;
    s.precision(4);
    s << value << unit;
    return s.str();
  };
  std::size_t dofs = 0;
  for (const Body<2> &body : state.bodies)
    dofs += body.rigid.driven ? 0 : body.field.n_dofs();
  const auto &cells = problem.lattice->n_cells();
  SizeReport report = {
      {"bodies", std::to_string(n_bodies())},
      {"material points", std::to_string(n_points())},
      {"background mesh", std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " cells of " +
                              text(problem.lattice->cell_size(), " m")},
      {"unknowns", std::to_string(dofs)},
      {"shape functions", problem.settings.shape},
      {"time scheme", problem.settings.scheme.in_words()},
      {"contact", problem.settings.contact_geometry},
      {"CFL step", text(cfl_step(), " s")},
      {"time step", text(wanted_step(), " s") + " = " + text(wanted_step() / cfl_step(), " CFL steps")}};
  add_ranks(report);
  return report;
}

std::map<std::string, double> MpmModel::phases() const
{
  return timer->get_summary_data(dealii::TimerOutput::total_wall_time);
}
} // namespace softgrain::mpm
