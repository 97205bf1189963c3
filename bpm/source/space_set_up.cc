// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of SpaceModel that makes primaries from a scene.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/base/preparation.h>
#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/space_model.h>
#include <softgrain/geometry/cluster_surface.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <map>

namespace softgrain::bpm
{
namespace
{
/// Bodies of one form share fillings when there are more than so many of them, as in the plane.
constexpr std::size_t enough_fillings = 100;

/// Vertices of a surface for every primary at it.
constexpr double vertices_of_a_primary = 4.;

/// Which filling each body has: what it is made of, and its number among those.
using Filling = std::pair<std::vector<double>, std::size_t>;

std::vector<Filling> fillings_of(const Scene<3> &scene, const unsigned int variants)
{
  std::vector<Filling> fillings;
  std::map<std::vector<double>, std::vector<std::size_t>> alike;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    const BodyDescription<3> &body = scene.bodies[b];
    // Where a body is does not count.
    std::vector<double> form = body.shape->numbers();
    const std::array<double, 3> center = {body.center[0], body.center[1], body.center[2]};
    const auto place = std::search(form.begin(), form.end(), center.begin(), center.end());
    if (place != form.end())
      form.erase(place, place + 3);
    form.push_back(body.material);
    std::size_t filling = variants > 0 ? b % variants : b;
    if (variants == 0)
    {
      std::vector<std::size_t> &same = alike[form];
      if (same.size() >= enough_fillings)
        filling = same[same.size() % enough_fillings];
      same.push_back(b);
    }
    fillings.emplace_back(form, filling);
  }
  return fillings;
}
} // namespace

SpaceModel::SpaceModel(const Scene<3> &scene_description, const Settings &model_settings, const Laws &laws)
    : scene(scene_description)
    , settings(model_settings)
    , timer(std::make_unique<dealii::TimerOutput>(
          std::cout, dealii::TimerOutput::never, dealii::TimerOutput::wall_times))
    , moving_walls(make_walls(scene))
{
  settings.dynamics.pairs = ContactPairs(scene);
  Laws law_of_body;
  double contact_force = 0.;
  for (const BodyDescription<3> &body : scene.bodies)
  {
    density.push_back(scene.materials[body.material].density);
    law_of_body.push_back(laws[body.material]);
    contact_force = std::max(contact_force, laws[body.material]->contact_force());
    characteristic_force = std::max(characteristic_force, laws[body.material]->characteristic_force());
  }
  Balls balls = fill_bodies(laws);
  if (settings.dynamics.rotations())
    give_spins(balls);
  if (contact_force > 0.)
    natural_time = attraction_time<3>(balls.mean_diameter(),
                                      *std::min_element(density.begin(), density.end()), contact_force);
  if (wanted_step() <= 0.)
    throw InputError("'Time/Time step' = '0' is not allowed when no material attracts: give a step");
  double volume = 0.;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    volume += size_of_primary<3>(balls.radius[i]);
    mass += balls.mass[i];
  }
  settings.dynamics.wall_force_floor =
      settings.wall_floor * characteristic_force * std::pow(std::cbrt(volume) / balls.mean_diameter(), 2);
  // More than a step, for what it accelerates.
  settings.dynamics.look_ahead = 1.5 * wanted_step();
  if (scene.loads.look_at_points())
    balls.start = balls.position;
  directions = cluster_directions(double(balls.size()) / scene.bodies.size(), vertices_of_a_primary);
  dynamics = std::make_unique<BallDynamics>(std::move(balls), law_of_body, settings.dynamics);
  dynamics->set_timer(timer.get());
  for (Wall<3> &wall : moving_walls)
    plan(wall, 0., wanted_step());
  dynamics->detect(moving_walls);
  check_apart();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    volume_at_start.push_back(enclosed_volume(surface_of(b)));
  impulse = dynamics->sums().momentum;
}

Balls SpaceModel::fill_bodies(const Laws &laws)
{
  const dealii::TimerOutput::Scope section(*timer, "preparation of aggregates");
  const std::vector<Filling> fillings = fillings_of(scene, settings.primaries.variants);
  std::map<Filling, std::size_t> place;
  std::vector<std::size_t> to_make; // one body for every filling
  for (std::size_t b = 0; b < fillings.size(); ++b)
    if (place.emplace(fillings[b], to_make.size()).second)
      to_make.push_back(b);
  std::vector<Aggregate<3>> made(to_make.size());
  std::vector<std::exception_ptr> errors(to_make.size());
  Preparation telling("aggregates", to_make.size());
  parallel_for(to_make.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t k = begin; k < end; ++k)
                   try
                   {
                     const std::size_t b = to_make[k];
                     made[k] =
                         make_aggregate(scene.bodies[b], density[b], laws[scene.bodies[b].material], settings,
                                        settings.primaries.seed * 1000003u + fillings[b].second);
                     telling.advance();
                   }
                   catch (...)
                   {
                     errors[k] = std::current_exception();
                   }
               });
  for (const std::exception_ptr &error : errors)
    if (error)
      std::rethrow_exception(error);
  Balls balls;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    const Aggregate<3> &aggregate = made[place.at(fillings[b])];
    const BodyDescription<3> &body = scene.bodies[b];
    const std::vector<Expression> velocity = vector_expression(body.velocity, {"x", "y", "z"}, 3);
    first_of_body.push_back(balls.size());
    for (std::size_t i = 0; i < aggregate.size(); ++i)
    {
      std::array<double, 3> x = aggregate.position[i];
      for (unsigned int d = 0; d < 3; ++d)
        x[d] += body.center[d];
      balls.position.push_back(x);
      const auto component = [&](const unsigned int d) { return velocity[d]({x[0], x[1], x[2]}); };
      balls.velocity.push_back({component(0), component(1), component(2)});
      balls.radius.push_back(aggregate.radius[i]);
      balls.mass.push_back(size_of_primary<3>(aggregate.radius[i]) * density[b]);
      balls.body.push_back(b);
    }
  }
  first_of_body.push_back(balls.size());
  return balls;
}

void SpaceModel::give_spins(Balls &balls) const
{
  // Half of the curl of the velocity, over the ball: exact where a body turns as a whole.
  std::vector<std::vector<Expression>> velocity;
  for (const BodyDescription<3> &body : scene.bodies)
    velocity.push_back(vector_expression(body.velocity, {"x", "y", "z"}, 3));
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const double r = balls.radius[i];
    // Difference of component v across the ball along x_d.
    const auto slope = [&](const unsigned int v, const unsigned int d)
    {
      std::array<double, 3> up = balls.position[i], down = up;
      up[d] += r;
      down[d] -= r;
      const Expression &formula = velocity[balls.body[i]][v];
      return (formula({up[0], up[1], up[2]}) - formula({down[0], down[1], down[2]})) / (2. * r);
    };
    balls.angular_velocity.push_back({0.5 * (slope(2, 1) - slope(1, 2)), 0.5 * (slope(0, 2) - slope(2, 0)),
                                      0.5 * (slope(1, 0) - slope(0, 1))});
  }
}

void SpaceModel::check_apart() const
{
  const std::size_t row = dynamics->present().deepest_row(true);
  if (row < dynamics->present().gaps().size() &&
      -dynamics->present().gaps()[row] > settings.largest_penetration * dynamics->mean_diameter())
    throw InputError("at the start " + where_is(row) +
                     ": move one of them, or change 'Primaries/Number per body'");
}
} // namespace softgrain::bpm
