// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/bpm_forecast.h>
#include <softgrain/bpm/strip_share.h>
#include <softgrain/contact/disk_solver.h>
#include <softgrain/contact/strip_grid.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/scene/contact_pairs.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
/// Fitted to processor time and peak memory of runs of the shipped scenes on one thread.
namespace fitted
{
constexpr double contacts = 2.15;              ///< of a primary
constexpr double sweep_seconds = 5.2e-9;       ///< of a contact
constexpr double sweeps = 55.;                 ///< of a step that is short
constexpr double sweeps_of_step = 480.;        ///< more, per sqrt(m a0 / F0) of its length
constexpr double pressed_factor = 1.25;        ///< on the sweeps, walls under pressure
constexpr double primary_seconds = 0.7e-6;     ///< of a step without the contact solve
constexpr double picture_seconds = 1e-5;       ///< of a primary in a picture
constexpr double history_seconds = 1e-6;       ///< of a primary in a row of the history
constexpr double preparation_seconds = 2.1e-5; ///< of an aggregate, per power 3/2 of its number of primaries
constexpr double rim = 1.1;                    ///< that primaries leave empty, over their diameter
constexpr double aggregate_seconds = 3e-3;     ///< of an aggregate, however small
constexpr double packing_seconds = 4e-3;       ///< of a grain
constexpr double primary_memory = 1.8e3;       ///< [bytes]
constexpr double divided_work = 0.87;          ///< among processes that have all primaries
} // namespace fitted

/// Those of one body: fewer the larger they are, because none reaches beyond the outline.
double n_primaries(const BodyGroup &body, const PrimarySettings &primaries)
{
  if (primaries.number > 0)
    return primaries.number;
  const double x = std::sqrt(primaries.sizes.mean_area() / body.area);
  // Fitted to hundreds of primaries in a body, and to a few.
  const double share = std::min(0.82, std::pow(std::max({0.2, 1.013 - 2.77 * x, 0.893 - x}), 2));
  return std::max(1., share / (x * x));
}

/// Whether several can have some of the primaries each, see Dynamics::share_by().
bool can_part(const Scene<2> &scene)
{
  return scene.obstacles.empty() && !ContactPairs(scene).adhere() &&
         std::none_of(scene.walls.begin(), scene.walls.end(),
                      [](const WallDescription<2> &wall)
                      { return wall.type == WallDescription<2>::Type::periodic; });
}

std::string text(const double value, const std::string &unit)
{
  std::ostringstream s;
  s.precision(3);
  s << value << unit;
  return s.str();
}

std::vector<std::string> warnings(const Scene<2> &scene,
                                  const Settings &settings,
                                  const double relative_step,
                                  const RunOutline &run,
                                  const double per_body)
{
  std::vector<std::string> list;
  if ((has_friction(scene) || rough(scene.obstacles)) && per_body > 1.5 &&
      settings.dynamics.rolling_resistance == 0.)
    list.push_back(
        "friction hardly acts on bonded bodies whose primaries roll, and 'Contact/Rolling resistance' is "
        "0: set it and 'Contact/Inner rolling resistance' to 1 or more (doc/bonded-particles.md, Friction)");
  if (relative_step > 0.3)
    list.push_back("the time step is " + text(relative_step, " sqrt(m a0/F0)") +
                   ": from 0.3 on steps are cut for overlap, and stresses are 5 % too high and more");
  else if (relative_step > 0.2 && run.crowd.n_bodies() > 1.5)
    list.push_back("the time step is " + text(relative_step, " sqrt(m a0/F0)") +
                   ": stresses of assemblies were 5 % too high at 0.24");
  if (per_body < 30.)
    list.push_back("a body has about " + count_in_words(per_body) +
                   " primaries: it hardly deforms like a solid, 100 and more are usual");
  return list;
}
} // namespace

Forecast forecast(const Scene<2> &scene,
                  const Settings &settings,
                  const std::vector<std::shared_ptr<const Attraction>> &laws,
                  const RunOutline &run)
{
  Forecast result;
  const SizeDistribution &sizes = settings.primaries.sizes;
  const double diameter = std::sqrt(4. * sizes.mean_area() / dealii::numbers::PI);
  double force = 0., density = 0., fewest = 0.;
  for (const BodyGroup &body : run.crowd.groups)
  {
    const double n = n_primaries(body, settings.primaries);
    check_number(body.name, n);
    result.n_points += body.count * n;
    const double made = settings.primaries.variants > 0
                            ? std::min<double>(settings.primaries.variants, body.count)
                            : body.count;
    result.preparation += made * (fitted::aggregate_seconds + fitted::preparation_seconds * std::pow(n, 1.5));
    fewest = fewest == 0. ? n : std::min(fewest, n);
    force = std::max(force, laws[body.material]->contact_force());
    const double own = scene.materials[body.material].density;
    density = density == 0. ? own : std::min(density, own);
  }
  const double natural_time = force > 0. ? attraction_time<2>(diameter, density, force) : 0.;
  result.step = settings.step.wanted(settings.step_fraction * natural_time);
  result.n_steps = run.n_steps(result.step);
  const double relative_step = natural_time > 0. ? result.step / natural_time : 0.;
  double sweeps = fitted::sweeps + fitted::sweeps_of_step * std::min(relative_step, 1.);
  if (run.pressed && run.crowd.n_bodies() > 1.5)
    sweeps *= fitted::pressed_factor;
  double seconds = fitted::contacts * fitted::sweep_seconds * sweeps + fitted::primary_seconds +
                   fitted::history_seconds / run.history_every;
  if (result.n_steps > 0.)
    seconds += run.n_pictures / result.n_steps * fitted::picture_seconds;
  result.step_seconds = seconds * result.n_points;
  if (run.to_pack)
    result.preparation += fitted::packing_seconds * run.crowd.n_bodies();
  result.memory = fitted::primary_memory * result.n_points;
  // An owner has a tile of each of the two colours at least.
  const double tiles = result.n_points / contact::StripGrid::disks_per_strip;
  if (can_part(scene) && result.n_points > fewest_to_part)
    result.divided = {1., 1., 1., 0.5 * tiles};
  else if (fitted::contacts * result.n_points > contact::contacts_to_share)
    result.divided = {1., fitted::divided_work, 0., 0.5 * tiles};
  result.warnings = warnings(scene, settings, relative_step, run, fewest);
  result.sizes = {{"primaries", "about " + count_in_words(result.n_points)},
                  {"mean diameter", "about " + text(diameter, " m")},
                  {"time step", natural_time > 0.
                                    ? text(result.step, " s = ") + text(relative_step, " sqrt(m a0/F0)")
                                    : text(result.step, " s")}};
  return result;
}

double solid_area(const Settings &settings, const Crowd &crowd)
{
  double sum = 0.;
  for (const BodyGroup &body : crowd.groups)
  {
    const double x = std::sqrt(settings.primaries.sizes.mean_area() / body.area);
    sum +=
        body.count * body.area * (settings.primaries.number > 0 ? 1. : 1. - std::min(0.3, fitted::rim * x));
  }
  return sum;
}
} // namespace softgrain::bpm
