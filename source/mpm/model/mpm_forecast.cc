// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/model/body_cost.h>
#include <softgrain/mpm/model/long_steps.h>
#include <softgrain/mpm/model/mpm_forecast.h>
#include <softgrain/scene/contact_pairs.h>
#include <softgrain/scene/motion_at_start.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
/// Fitted to processor time and peak memory of runs of the shipped scenes on one thread.
namespace fitted
{
constexpr double explicit_seconds = 0.4e-6;  ///< of a step of a point without a matrix
constexpr double grid_seconds = 0.18e-6;     ///< of a point when a new grid is laid
constexpr double picture_seconds = 6e-6;     ///< of a point in a picture
constexpr double history_seconds = 1.5e-7;   ///< of a point in a row of the history
constexpr double preparation_seconds = 2e-5; ///< of a point
constexpr double packing_seconds = 4e-3;     ///< of a grain
constexpr double slow_friction_factor = 2.6; ///< on the time of a step in which no waves are resolved
constexpr double obstacle_factor = 1.35;     ///< the same, one body at obstacles
constexpr double rough_factor = 3.5;         ///< the same, one body that may slip
constexpr double f_bar_factor = 2.7;         ///< on the iterations, where matter flows and keeps its volume
constexpr double f_bar_point_factor = 2.0;   ///< on what they take per point
constexpr double pressed_factor = 2.6;       ///< the same, walls under pressure
// The same where rays meet contact, without inertia.
constexpr double rays_factor = 0.72, most_of_rays = 2.; ///< several bodies: the first times n^0.3
constexpr double rays_friction_factor = 1.5, rays_obstacle_factor = 2., rays_f_bar_factor = 6.;
constexpr double falling_way = 0.33; ///< cells in a step, where bodies fall on each other
constexpr double divided_work = 0.86, divided_memory = 0.8; ///< among owners, see doc/results/ranks
constexpr double divided_points = 0.9; ///< the same, of the time before the first step but for packing
} // namespace fitted

/// Whether dilatations are averaged over cells, in one of the bodies.
bool has_f_bar(const Settings &settings,
               const std::vector<std::shared_ptr<const constitutive::Law<2>>> &laws,
               const Crowd &crowd)
{
  return std::any_of(crowd.groups.begin(), crowd.groups.end(),
                     [&](const BodyGroup &body)
                     { return settings.averages_dilatations(laws[body.material]->poisson_ratio()); });
}

/// Whether matter of one of the bodies flows: it remembers what it went through, and not how far it has
/// grown.
bool flows(const std::vector<std::shared_ptr<const constitutive::Law<2>>> &laws, const Crowd &crowd)
{
  return std::any_of(crowd.groups.begin(), crowd.groups.end(),
                     [&laws](const BodyGroup &body)
                     { return laws[body.material]->n_history() > 0 && !laws[body.material]->is_active(); });
}

/// Iterations of Newton's method in a step.
double n_iterations(const Settings &settings, const RunOutline &run, const double dt, const double cfl)
{
  const double n_bodies = run.crowd.n_bodies();
  if (!settings.scheme.solves_equations())
    return 1.;
  if (settings.scheme.ends_in_balance())
  {
    const double way = run.fastest_wall * dt / settings.finest_cell();
    const double longer = std::clamp(std::pow(way / 0.1, 0.4), 1., 1.6);
    if (settings.meets_by_rays())
      return n_bodies < 1.5 ? 2.2 : 1.8 * std::pow(n_bodies, 0.44) * longer;
    return n_bodies < 1.5 ? 5.5 : 9. * std::pow(n_bodies, 0.4) * longer;
  }
  if (settings.meets_by_rays() && dt > resolves_waves_to * cfl)
    return 3. * std::pow(n_bodies, 0.2);
  return n_bodies < 1.5 ? 2. : 2.6 + 0.6 * std::min(dt / cfl, 10.);
}

/// Factor on the time of a step, for what is in contact.
double factor_of_contacts(const Settings &settings,
                          const RunOutline &run,
                          const bool slow,
                          const bool friction,
                          const bool obstacles)
{
  const bool many = run.crowd.n_bodies() > 1.5, rays = settings.meets_by_rays();
  if (!slow)
    return 1.;
  if (rays && many)
    return std::min(fitted::most_of_rays, fitted::rays_factor * std::pow(run.crowd.n_bodies(), 0.3)) *
           (friction ? fitted::rays_friction_factor : 1.);
  if (many)
    return (friction ? fitted::slow_friction_factor : 1.) * (run.pressed ? fitted::pressed_factor : 1.);
  return (!obstacles ? 1.
          : rays     ? fitted::rays_obstacle_factor
                     : fitted::obstacle_factor) *
         (friction ? fitted::rough_factor : 1.);
}

/// What is left of a step @p dt where bodies fall onto each other: half of the time they are faster than at
/// half the height of the mesh.
double cut_by_falls(const Scene<2> &scene, const Settings &settings, const RunOutline &run, const double dt)
{
  const double g = scene.loads.uniform(0.).norm(),
               height = (settings.mesh_upper - settings.mesh_lower).norm();
  if (g == 0. || run.crowd.n_bodies() < 1.5 || settings.scheme.ends_in_balance())
    return dt;
  const double longest = run.duration > 0. ? run.duration : std::numeric_limits<double>::max();
  const double speed = 0.5 * std::min(g * longest, std::sqrt(2. * g * height));
  return std::min(dt, fitted::falling_way * settings.finest_cell() / speed);
}

std::string text(const double value, const std::string &unit)
{
  std::ostringstream s;
  s.precision(3);
  s << value << unit;
  return s.str();
}

/// Largest difference of velocities with which bodies start, walls at rest among them [m/s].
double fastest_approach(const Scene<2> &scene)
{
  dealii::Tensor<1, 2> least, most;
  bool first = scene.walls.empty();
  for (const BodyDescription<2> &body : scene.bodies)
  {
    if (body.velocity.empty())
      continue;
    const std::vector<Expression> velocity = vector_expression(body.velocity, {"x", "y"});
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double speed = velocity[d]({body.center[0], body.center[1]});
      least[d] = first ? speed : std::min(least[d], speed);
      most[d] = first ? speed : std::max(most[d], speed);
    }
    first = false;
  }
  return (most - least).norm();
}

/// What doc/results/trade.md says of such cells and steps.
std::vector<std::string> warnings(
    const Scene<2> &scene, const Settings &settings, const RunOutline &run, const double dt, const double cfl)
{
  const bool walls = !scene.walls.empty();
  std::vector<std::string> list;
  const double h = settings.cell_size, wave_speed = settings.finest_cell() / cfl;
  // The thinnest body says it for all.
  const BodyGroup *thinnest = nullptr;
  for (const BodyGroup &body : run.crowd.groups)
    if (!body.driven && (thinnest == nullptr || body.thickness < thinnest->thickness))
      thinnest = &body;
  if (thinnest != nullptr)
  {
    const double cells = thinnest->thickness / h;
    const std::string what = "'Mesh/Cell size' = " + text(h, " m") + " is " + text(1. / cells, "") +
                             " of the width of " + thinnest->thinnest + ", " +
                             text(thinnest->thickness, " m");
    if (cells < 1.)
      list.push_back("'Mesh/Cell size' = " + text(h, " m") + " is larger than " + thinnest->thinnest + ", " +
                     text(thinnest->thickness, " m") + " wide: it can hardly deform");
    else if (run.crowd.n_bodies() > 1.5 && cells < 2.6)
      list.push_back(what + ": stresses of assemblies are 15 % off and more");
    else if (walls && run.crowd.n_bodies() < 1.5 && cells < 8.)
      list.push_back(what + ": contact forces are 5 % off and more, 12 cells make it 3 %");
  }
  const double way = run.fastest_wall * dt / settings.finest_cell();
  if (settings.scheme.ends_in_balance() && run.crowd.n_bodies() > 1.5 && way > 0.5)
    list.push_back("a wall moves " + text(way, " cells") +
                   " in a step: assemblies without inertia were studied with up to 0.3");
  const bool by_waves = settings.wall_way == 0. && settings.step.time_step == 0.;
  if (settings.scheme.ends_in_balance() && by_waves && way > 0. && way < 0.02)
    list.push_back(
        "a wall moves " + text(way, " cells") +
        " in a step, for steps follow 'Time/CFL multiple': there are no waves without inertia, and "
        "'Time/Wall way' = 0.1 makes " +
        text(0.1 / way, "") + " times fewer");
  if (!settings.scheme.ends_in_balance() && run.crowd.n_bodies() > 1.5 &&
      settings.scheme.solves_equations() && way > 1.)
    list.push_back("a wall moves " + text(way, " cells") + " in a step: steps will be cut");
  if (!settings.scheme.ends_in_balance() && run.fastest_wall > 0.1 * wave_speed)
    list.push_back("a wall moves at " + text(run.fastest_wall, " m/s") + ", waves at " +
                   text(wave_speed, " m/s") + ": bodies are crushed where they meet it");
  const double approach = !settings.scheme.ends_in_balance() ? fastest_approach(scene) : 0.;
  if (approach > 0.3 * wave_speed)
    list.push_back("bodies start with velocities that differ by " + text(approach, " m/s") +
                   ", waves run at " + text(wave_speed, " m/s") + ": what meets is crushed");
  return list;
}

/// The step without which waves would cross a cell [s].
double cfl_of(const Scene<2> &scene,
              const Settings &settings,
              const std::vector<std::shared_ptr<const constitutive::Law<2>>> &laws,
              const Crowd &crowd)
{
  double step = 0.;
  for (const BodyGroup &body : crowd.groups)
  {
    if (body.driven)
      continue;
    const double own = settings.finest_cell() * std::sqrt(scene.materials[body.material].density /
                                                          laws[body.material]->wave_modulus());
    step = step == 0. ? own : std::min(step, own);
  }
  return step;
}

/// Slabs are three cells thick and as long as the mesh.
double points_of_slabs(const Scene<2> &scene, const Settings &settings)
{
  double sum = 0.;
  for (const WallDescription<2> &wall : scene.walls)
    if (wall.type == WallDescription<2>::Type::material_points)
      sum += 3. * std::pow(settings.points_per_direction, 2) / settings.finest_cell() *
             std::abs((settings.mesh_upper - settings.mesh_lower) *
                      dealii::Tensor<1, 2>({wall.normal[1], wall.normal[0]}));
  return sum;
}

/// @param unknowns of all bodies, @param cfl the step in which a wave crosses a cell [s]
SizeReport sizes_of(const Settings &settings, const Forecast &result, const double unknowns, const double cfl)
{
  const auto cells_along = [&settings](const unsigned int d)
  {
    const double length = settings.mesh_upper[d] - settings.mesh_lower[d];
    return std::to_string(std::llround(std::ceil(length / settings.finest_cell() * (1. - 1e-9))));
  };
  return {{"material points", "about " + count_in_words(result.n_points)},
          {"background mesh",
           cells_along(0) + " x " + cells_along(1) + " cells of " + text(settings.finest_cell(), " m")},
          {"unknowns", "about " + count_in_words(unknowns)},
          {"shape functions", settings.shape},
          {"time scheme", settings.scheme.name},
          {"contact", settings.contact_geometry},
          {"CFL step", text(cfl, " s")},
          {"time step", text(result.step, " s = ") + text(result.step / cfl, " CFL steps")}};
}
} // namespace

Forecast forecast(const Scene<2> &scene,
                  const Settings &settings,
                  const std::vector<std::shared_ptr<const constitutive::Law<2>>> &laws,
                  const RunOutline &run)
{
  Forecast result;
  double unknowns = 0., factors = 0., memory = 0.;
  for (const BodyGroup &group : run.crowd.groups)
  {
    const BodyCost cost = cost_of(group, settings);
    result.n_points += group.count * cost.points;
    unknowns += group.count * cost.unknowns;
    factors += group.count * cost.factor_seconds;
    if (run.crowd.n_bodies() < 1.5 && (!scene.walls.empty() || !scene.obstacles.empty()))
      factors += cost.condense_seconds; // with several bodies it is in what a point costs
    memory += group.count * cost.memory;
  }
  result.n_points += points_of_slabs(scene, settings);
  const double cfl = cfl_of(scene, settings, laws, run.crowd), points = result.n_points;
  result.step = settings.step.wanted(settings.scheme.cfl_multiple(settings.cfl_multiple) * cfl);
  const bool waves_count = settings.chosen_way && !settings.scheme.ends_in_balance() &&
                           (run.pressed || moved_by_more_than_walls(scene));
  if (settings.wall_way > 0. && run.fastest_wall > 0.)
    result.step =
        std::min(settings.wall_way * settings.finest_cell() / run.fastest_wall,
                 waves_count ? result.step : settings.step.wanted(std::numeric_limits<double>::max()));
  result.n_steps = run.n_steps(cut_by_falls(scene, settings, run, result.step));
  const bool friction = has_friction(scene) || rough(scene.obstacles);
  const bool slow = settings.scheme.ends_in_balance() ||
                    (settings.follows_contact() && result.step > resolves_waves_to * cfl);
  const bool f_bar = has_f_bar(settings, laws, run.crowd);
  double iterations = n_iterations(settings, run, result.step, cfl);
  if (slow && f_bar && flows(laws, run.crowd))
    iterations *= settings.meets_by_rays() ? fitted::rays_f_bar_factor : fitted::f_bar_factor;
  double of_point = BodyCost::point_seconds + (run.crowd.n_bodies() > 1.5 ? BodyCost::contact_seconds : 0.);
  if (f_bar)
    of_point *= fitted::f_bar_point_factor;
  double seconds = settings.scheme.solves_equations() ? iterations * (of_point * points + factors)
                                                      : fitted::explicit_seconds * points;
  seconds *= factor_of_contacts(settings, run, slow, friction, !scene.obstacles.empty());
  if (settings.grid_update == GridUpdate::every_step)
    seconds += fitted::grid_seconds * points;
  seconds += fitted::history_seconds * points / run.history_every;
  if (result.n_steps > 0.)
    seconds += run.n_pictures / result.n_steps * fitted::picture_seconds * points;
  result.step_seconds = seconds;
  result.preparation = fitted::preparation_seconds * points +
                       (run.to_pack ? fitted::packing_seconds * run.crowd.n_bodies() : 0.);
  result.memory = memory;
  result.divided = {result.preparation > 0.
                        ? fitted::divided_points * fitted::preparation_seconds * points / result.preparation
                        : 0.,
                    fitted::divided_work, fitted::divided_memory, run.crowd.n_bodies()};
  result.warnings = warnings(scene, settings, run, result.step, cfl);
  result.sizes = sizes_of(settings, result, unknowns, cfl);
  return result;
}
} // namespace softgrain::mpm
