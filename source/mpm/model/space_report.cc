// SPDX-License-Identifier: LGPL-2.1-or-later
// What SpaceModel tells of itself: walls, sums, energies, sizes, times.
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/model/rank_report.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

namespace softgrain::mpm
{
std::vector<WallState<3>> SpaceModel::walls() const
{
  return states_of(driven);
}

Energies SpaceModel::energies() const
{
  Energies energies;
  energies.elastic = state.dent_energy;
  for (const auto &[stored] :
       work.share.numbers<1>(state.bodies,
                             [](const Body<3> &body)
                             {
                               return std::array<double, 1>{
                                   measure_points(body, body.nodes.displacement,
                                                  Eigen::VectorXd::Zero(body.nodes.displacement.size()))
                                       .energy};
                             }))
    energies.elastic += stored;
  for (const Body<3> &body : state.bodies)
    energies.kinetic += body.nodes.kinetic_energy();
  for (const Wall<3> &wall : driven)
    energies.kinetic += at_rest() ? 0. : kinetic_energy_of(wall);
  energies.dissipated = state.losses.regularisation + state.losses.released + state.losses.rubbed +
                        state.motion.scheme_damping + state.motion.contact_loss + state.motion.wall_damping +
                        state.laws.loss;
  energies.external_work = state.load_work.sum() + state.laws.supply;
  energies.external_work += state.motion.cell_work;
  for (const Wall<3> &wall : driven)
    energies.external_work += wall.book.work;
  for (const Obstacle<3> &obstacle : state.obstacles)
    energies.external_work += obstacle.work;
  return energies;
}

dealii::Tensor<1, 3> SpaceModel::momentum() const
{
  dealii::Tensor<1, 3> sum;
  for (const Body<3> &body : state.bodies)
    sum += body.nodes.momentum();
  return sum;
}

double SpaceModel::momentum_error() const
{
  const double scale = std::max(state.motion.largest_momentum, state.motion.impulse.norm());
  if (at_rest() || scale == 0.)
    return std::numeric_limits<double>::quiet_NaN();
  return (momentum() - state.motion.impulse).norm() / scale;
}

double SpaceModel::energy_of_rounding() const
{
  double sum = 0.;
  for (const Body<3> &body : state.bodies)
    sum += 1e-12 * body.material.law->young_modulus() * body.rest.area;
  return sum;
}

StepState<3> SpaceModel::stress_of(const Body<3> &body) const
{
  StepState<3> stress;
  Trial asked;
  asked.tangent = false;
  evaluate_stress(body, body.nodes.displacement, Eigen::VectorXd::Zero(body.nodes.displacement.size()), asked,
                  stress);
  return stress;
}

double SpaceModel::solid_area() const
{
  double sum = 0.;
  for (const auto &[volume] : work.share.numbers<1>(state.bodies,
                                                    [this](const Body<3> &body)
                                                    {
                                                      const StepState<3> stress = stress_of(body);
                                                      double of_body = 0.;
                                                      for (unsigned int p = 0; p < body.points.size(); ++p)
                                                        of_body += body.points[p].rest_volume() *
                                                                   determinant(stress.gradient[p]);
                                                      return std::array<double, 1>{of_body};
                                                    }))
    sum += volume;
  return sum;
}

double SpaceModel::coordination() const
{
  // Partners, every image of them, and walls, once each.
  std::set<std::tuple<unsigned int, unsigned int, unsigned int, PeriodicCell<3>::Image>> pairs;
  for (const SpaceContact &contact : state.contacts)
  {
    const PeriodicCell<3>::Image &n = contact.image;
    pairs.insert({contact.body, contact.partner, contact.wall, n});
    if (contact.partner != ContactFrame<3>::none)
      pairs.insert({contact.partner, contact.body, contact.wall, {{-n[0], -n[1], -n[2]}}});
  }
  return static_cast<double>(pairs.size()) / state.bodies.size();
}

std::size_t SpaceModel::n_points() const
{
  std::size_t n = 0;
  for (const Body<3> &body : state.bodies)
    n += body.n_points;
  return n;
}

SizeReport SpaceModel::size_report() const
{
  std::ostringstream cells;
  cells << settings.cell_size << " m";
  std::size_t nodes = 0;
  for (const Body<3> &body : state.bodies)
    nodes += body.field.n_independent();
  SizeReport report = {{"bodies", std::to_string(state.bodies.size())},
                       {"cell size", cells.str()},
                       {"material points", std::to_string(n_points())},
                       {"nodes", std::to_string(nodes)}};
  if (!work.share.alone())
    report_idle_ranks(report_bodies_of_ranks(work.share, state.bodies, report), report);
  return report;
}

std::vector<std::pair<std::string, double>> SpaceModel::works() const
{
  std::vector<std::pair<std::string, double>> columns;
  for (const Wall<3> &wall : driven)
    columns.emplace_back(wall.description.name + "_work_J", wall.book.work);
  for (const Obstacle<3> &obstacle : state.obstacles)
    columns.emplace_back(obstacle.description.name + "_work_J", obstacle.work);
  for (const std::string &load : loads.names())
    columns.emplace_back(load + "_work_J", state.load_work.of(load));
  if (any_sides(driven) && !at_rest())
    columns.emplace_back("cell_work_J", state.motion.cell_work);
  if (std::any_of(state.bodies.begin(), state.bodies.end(),
                  [](const Body<3> &body) { return body.material.law->is_active(); }))
    columns.emplace_back("growth_work_J", state.laws.supply);
  return columns;
}

std::vector<std::pair<std::string, double>> SpaceModel::extra_history() const
{
  std::vector<std::pair<std::string, double>> columns;
  for (const Wall<3> &wall : driven)
    if (wall.description.drive->slides())
      columns.emplace_back(wall.description.name + "_tangential_force_N", state_of(wall).tangential_force);
  if (std::any_of(state.bodies.begin(), state.bodies.end(),
                  [](const Body<3> &body) { return body.material.law->limits_step(); }))
    columns.emplace_back("law_cuts", state.law_cuts);
  if (at_rest())
    return columns;
  double rotational = 0.;
  for (const Body<3> &body : state.bodies)
  {
    const WholeRotation<3> r = whole_rotation(body);
    const Turn<3> rate = r.transpose() * body.nodes.velocity;
    for (unsigned int axis = 0; axis < 3; ++axis)
      rotational += 0.5 * rate[axis] * rate[axis] * rotary_inertia(body, Eigen::VectorXd(r.col(axis)));
  }
  columns.insert(columns.end(), {{"force_time_s", settings.scheme.force_time(state.time, last_dt)},
                                 {"contact_loss_J", state.motion.contact_loss},
                                 {"rotational_energy_J", rotational},
                                 {"scheme_damping_J", state.motion.scheme_damping},
                                 {"regularisation_work_J", state.losses.regularisation}});
  return columns;
}

std::map<std::string, double> SpaceModel::phases() const
{
  return timer->get_summary_data(dealii::TimerOutput::total_wall_time);
}
} // namespace softgrain::mpm
