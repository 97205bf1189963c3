// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of BpmModel that makes primaries from a scene.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/base/preparation.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/aggregate_library.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/model/state_file.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
/// Who makes aggregate @p i.
unsigned int maker(const std::size_t i, const Exchange &exchange)
{
  return i % exchange.number();
}

/// Gives all the aggregates that each has made.
void share(std::vector<Aggregate<2>> &made, const Exchange &exchange)
{
  if (exchange.alone())
    return;
  std::vector<double> sizes(made.size());
  std::vector<Exchange::Piece> pieces;
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    sizes[i] = made[i].size();
    pieces.push_back({maker(i, exchange), &sizes[i], 1});
  }
  exchange.share(pieces);
  pieces.clear();
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    made[i].position.resize(sizes[i]);
    made[i].radius.resize(sizes[i]);
    // Places of two numbers, one after the other in memory.
    pieces.push_back({maker(i, exchange), made[i].position.data()->data(), 2 * made[i].size()});
    pieces.push_back({maker(i, exchange), made[i].radius.data(), made[i].size()});
  }
  exchange.share(pieces);
}

/// Bodies of one form share fillings when there are more than so many of them.
constexpr std::size_t enough_fillings = 100;

/// Which aggregates a scene needs.
struct NeededAggregates
{
  std::vector<std::uint64_t> seeds; ///< of every body
  std::vector<std::string> keys;    ///< likewise
  std::vector<std::size_t> missing; ///< one body for every key that the library does not have
};

/// Every body has its own random numbers, or those of its variant; they are the same whoever comes first.
NeededAggregates needed_aggregates(const Scene<2> &scene,
                                   const Settings &settings,
                                   const std::vector<double> &density,
                                   const std::vector<std::string> &law_texts,
                                   const AggregateLibrary &library)
{
  NeededAggregates needed;
  std::map<std::string, std::vector<std::size_t>> alike; // bodies of the same form
  std::set<std::string> known;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    const BodyDescription<2> &body = scene.bodies[b];
    const unsigned int variants = settings.primaries.variants;
    std::size_t filling = variants > 0 ? b % variants : b;
    if (variants == 0)
    {
      std::vector<std::size_t> &same =
          alike[aggregate_key(body, density[b], law_texts[body.material], settings, 0)];
      if (same.size() >= enough_fillings)
        filling = same[same.size() % enough_fillings];
      same.push_back(b);
    }
    needed.seeds.push_back(settings.primaries.seed * 1000003u + filling);
    needed.keys.push_back(
        aggregate_key(body, density[b], law_texts[body.material], settings, needed.seeds[b]));
    if (library.find(needed.keys[b]) == nullptr && known.insert(needed.keys[b]).second)
      needed.missing.push_back(b);
  }
  return needed;
}

/// Sees to it that @p library has the aggregates of all bodies. @return their keys.
std::vector<std::string> prepare_aggregates(const Scene<2> &scene,
                                            const Settings &settings,
                                            const std::vector<double> &density,
                                            const std::vector<std::shared_ptr<const Attraction>> &laws,
                                            const std::vector<std::string> &law_texts,
                                            const Exchange &exchange,
                                            AggregateLibrary &library)
{
  const NeededAggregates needed = needed_aggregates(scene, settings, density, law_texts, library);
  const std::vector<std::size_t> &missing = needed.missing;
  std::vector<Aggregate<2>> made(missing.size());
  std::vector<std::exception_ptr> errors(missing.size());
  Preparation telling("aggregates", missing.size());
  const auto make_own = [&](const std::size_t begin, const std::size_t end)
  {
    for (std::size_t k = begin; k < end; ++k)
      try
      {
        const std::size_t b = missing[k];
        if (maker(k, exchange) == exchange.here())
          made[k] = make_aggregate(scene.bodies[b], density[b], laws[scene.bodies[b].material], settings,
                                   needed.seeds[b]);
        telling.advance();
      }
      catch (...)
      {
        errors[k] = std::current_exception();
      }
  };
  exchange.together(
      [&]()
      {
        parallel_for(missing.size(), 1, make_own);
        for (const std::exception_ptr &error : errors)
          if (error)
            std::rethrow_exception(error);
      });
  share(made, exchange);
  for (std::size_t k = 0; k < missing.size(); ++k)
    library.add(needed.keys[missing[k]], made[k]);
  return needed.keys;
}
} // namespace

BpmModel::BpmModel(const Scene<2> &scene_description,
                   const Settings &model_settings,
                   const std::vector<std::shared_ptr<const Attraction>> &laws,
                   const std::vector<std::string> &law_texts,
                   const StateReader *state)
    : scene(scene_description)
    , settings(model_settings)
    , timer(std::make_unique<dealii::TimerOutput>(
          std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times))
    , moving_walls(make_walls(scene))
    , moving_obstacles(make_obstacles(scene))
{
  settings.dynamics.pairs = ContactPairs(scene);
  settings.dynamics.contact_law = scene.contact_law;
  std::vector<std::shared_ptr<const Attraction>> law_of_body;
  double contact_force = 0.;
  for (const BodyDescription<2> &body : scene.bodies)
  {
    fixed.push_back(body.driven);
    density.push_back(scene.materials[body.material].density);
    law_of_body.push_back(laws[body.material]);
    contact_force = std::max(contact_force, laws[body.material]->contact_force());
    characteristic_force = std::max(characteristic_force, laws[body.material]->characteristic_force());
  }
  Primaries disks = state != nullptr ? primaries_of(*state) : fill_bodies(laws, law_texts);
  if (settings.dynamics.rotations() || rough(scene.obstacles))
  {
    disks.angular_velocity.resize(disks.size());
    for (std::size_t i = 0; i < disks.size(); ++i)
      disks.angular_velocity[i] = scene.bodies[disks.body[i]].angular_velocity;
  }
  choose_by_attraction(disks, contact_force);
  take_loads(disks);
  weigh(disks);
  is_graded = !disks.strength.empty();
  rotates = disks.rotate();
  diameter = disks.mean_diameter();
  dynamics = std::make_unique<Dynamics>(std::move(disks), law_of_body, fixed, settings.dynamics, timer.get());
  if (!moving_obstacles.empty())
    dynamics->set_obstacles(&moving_obstacles);

  if (state == nullptr)
    check_places();
  dynamics->share_by(exchange, moving_walls);
  drive_walls(0.);
  dynamics->detect(moving_walls);
  if (state == nullptr)
    check_apart();
  area_at_start = outlined_areas();
  balance.momentum.initial = dynamics->sums().momentum;
}

void BpmModel::choose_by_attraction(const Primaries &disks, double contact_force)
{
  if (!disks.strength.empty())
    contact_force *= *std::max_element(disks.strength.begin(), disks.strength.end());
  if (contact_force > 0.)
    natural_time = attraction_time<2>(disks.mean_diameter(),
                                      *std::min_element(density.begin(), density.end()), contact_force);
  if (wanted_step() <= 0.)
    throw InputError("'Time/Time step' = '0' is not allowed when no material attracts: give a step");
  double area = 0.;
  for (const double radius : disks.radius)
    area += dealii::numbers::PI * radius * radius;
  settings.dynamics.wall_force_floor =
      settings.wall_floor * characteristic_force / disks.mean_diameter() * std::sqrt(area);
  // More than a step, for what it accelerates.
  settings.dynamics.look_ahead = 1.5 * wanted_step();
}

void BpmModel::take_loads(Primaries &disks)
{
  for (const BodyDescription<2> &body : scene.bodies)
    own_load.push_back(body_force(body.body_force));
  const bool own = std::any_of(own_load.begin(), own_load.end(), [](const auto &load) { return bool(load); });
  load_names = scene.loads.names();
  if (own)
    load_names.push_back(name_of_body_force);
  is_loaded = own || scene.loads.look_at_points();
  if (is_loaded)
    disks.start = disks.position;
}

void BpmModel::weigh(const Primaries &disks)
{
  double least = std::numeric_limits<double>::max(), most = 0.;
  for (std::size_t i = 0; i < disks.size(); ++i)
  {
    const double own = disks.mass[i];
    if (fixed[disks.body[i]])
      continue;
    mass += own;
    if (own < least)
      lightest = disks.body[i];
    if (own > most)
      heaviest = disks.body[i];
    least = std::min(least, own);
    most = std::max(most, own);
  }
  contrast = most > 0. ? most / least : 1.;
}

Primaries BpmModel::fill_bodies(const std::vector<std::shared_ptr<const Attraction>> &laws,
                                const std::vector<std::string> &law_texts)
{
  const dealii::TimerOutput::Scope section(*timer, "preparation of aggregates");
  AggregateLibrary library(settings.primaries.aggregate_file);
  const std::vector<std::string> keys =
      prepare_aggregates(scene, settings, density, laws, law_texts, exchange, library);
  Primaries disks;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    const Aggregate<2> &aggregate = *library.find(keys[b]);
    const BodyDescription<2> &body = scene.bodies[b];
    const std::vector<Expression> velocity = vector_expression(body.velocity, {"x", "y"});
    first_of_body.push_back(disks.size());
    for (std::size_t i = 0; i < aggregate.size(); ++i)
    {
      const std::array<double, 2> &from_center = aggregate.position[i];
      const double x = body.center[0] + from_center[0], y = body.center[1] + from_center[1];
      disks.position.push_back({x, y});
      disks.velocity.push_back({velocity[0]({x, y}) - body.angular_velocity * from_center[1],
                                velocity[1]({x, y}) + body.angular_velocity * from_center[0]});
      disks.radius.push_back(aggregate.radius[i]);
      disks.mass.push_back(dealii::numbers::PI * disks.radius.back() * disks.radius.back() * density[b]);
      disks.body.push_back(b);
    }
  }
  first_of_body.push_back(disks.size());
  grade(disks);
  if (settings.primaries.keep_aggregates)
    exchange.at_first([&]() { library.save(); });
  return disks;
}

Primaries BpmModel::primaries_of(const StateReader &state)
{
  Primaries disks;
  for (const std::uint64_t first : state.read_keys("bpm/first_of_body", scene.bodies.size() + 1))
    first_of_body.push_back(first);
  if (first_of_body.front() != 0)
    state.refuse("bpm/first_of_body", "the first body does not begin with primary 0");
  disks.radius = state.read_doubles("bpm/radius", first_of_body.back());
  for (const double radius : disks.radius)
    if (!(radius > 0.))
      state.refuse("bpm/radius", "radii are positive");
  const std::vector<double> place = state.read_doubles("bpm/position", 2 * disks.radius.size());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
    {
      disks.position.push_back({place[2 * i], place[2 * i + 1]});
      disks.velocity.push_back({0., 0.});
      disks.mass.push_back(dealii::numbers::PI * disks.radius[i] * disks.radius[i] * density[b]);
      disks.body.push_back(b);
    }
  if (state.contains("bpm/strength"))
    disks.strength = state.read_doubles("bpm/strength", disks.radius.size());
  return disks;
}

void BpmModel::check_places() const
{
  const Primaries &disks = dynamics->disks();
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
  {
    const WallDescription<2> &wall = scene.walls[w];
    if (wall.type == WallDescription<2>::Type::periodic)
      continue;
    double deepest = 0.;
    std::uint32_t body = 0;
    for (std::size_t i = 0; i < disks.size(); ++i)
    {
      const dealii::Point<2> x(disks.position[i][0], disks.position[i][1]);
      const double gap = (x - wall.point) * wall.normal - disks.radius[i];
      if (gap < deepest)
      {
        deepest = gap;
        body = disks.body[i];
      }
    }
    if (deepest < -settings.largest_penetration * diameter)
    {
      std::ostringstream message;
      message << "primaries of body '" << scene.bodies[body].name << "' cross the wall '" << wall.name
              << "' by " << -deepest << " m: move the wall, or lower 'Primaries/Number per body'";
      throw InputError(message.str());
    }
  }
}

void BpmModel::check_apart() const
{
  const Overlap found = dynamics->deepest_overlap(true);
  if (found.depth > settings.largest_penetration * diameter)
    throw InputError("at the start " + where_is(found) +
                     ": move one of them, or change 'Primaries/Number per body'");
}
} // namespace softgrain::bpm
