// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/pressed_walls.h>
#include <softgrain/mpm/stepping/quasi_static.h>
#include <softgrain/mpm/stepping/stored_energy.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace softgrain::mpm
{
namespace
{
using Vector = dealii::Tensor<1, 2>;

/// Adds what one step took to what the steps before it took.
void add(const StepOutcome &step, StepOutcome &sum)
{
  sum.newton_iterations += step.newton_iterations;
  sum.contact_sweeps += step.contact_sweeps;
  sum.newton_residual = step.newton_residual;
  sum.contact_residual = step.contact_residual;
  sum.max_penetration = step.max_penetration;
}

/// Of the nodes of all bodies [m].
std::vector<Eigen::VectorXd> displacements(const World &world)
{
  std::vector<Eigen::VectorXd> all;
  for (const Body<2> &body : world.bodies)
    all.push_back(body.displacement);
  return all;
}

/// Cosine of the angle between two ways; 1 when there is none.
double cosine(const std::vector<Eigen::VectorXd> &a, const std::vector<Eigen::VectorXd> &b)
{
  double product = 0., square_a = 0., square_b = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
  {
    product += a[i].dot(b[i]);
    square_a += a[i].squaredNorm();
    square_b += b[i].squaredNorm();
  }
  return square_a * square_b > 0. ? product / std::sqrt(square_a * square_b) : 1.;
}

/// In a held step what is driven stands still, too; it goes on afterwards, however the step ends.
class DrivesAtRest
{
public:
  explicit DrivesAtRest(World &world) : world(world)
  {
    for (Body<2> &body : world.bodies)
    {
      drives.push_back(body.drive);
      body.drive = 0.;
    }
  }
  ~DrivesAtRest()
  {
    for (Body<2> &body : world.bodies)
      body.drive = drives[body.index];
  }
  DrivesAtRest(const DrivesAtRest &) = delete;

private:
  World &world;
  std::vector<dealii::Tensor<1, 2>> drives;
};

StepOutcome held_step(World &world, const StepPlan &plan)
{
  const DrivesAtRest rest(world);
  return implicit_step(world, plan);
}

/// Energy that no column of the balance explains [J/m].
double not_booked(const World &world)
{
  return stored_energy(world) + world.balance.dissipated() - world.balance.external_work();
}

std::string largest_move_in_cells(const World &world, const StepOutcome &held)
{
  std::ostringstream text;
  text.precision(3);
  text << held.largest_move / world.lattice->cell_size();
  return text.str();
}

StepOutcome make_held_steps(World &world, const double dt)
{
  const Settings &settings = world.settings;
  StepOutcome sum;
  sum.accepted = true;
  double of_bodies = unbalanced_force_here(world, dt);
  sum.unbalanced = std::max(of_bodies, unbalanced_walls(world));
  // Balance is where the regularising forces have gone. Weaker ones go sooner, as long as Newton follows.
  StepPlan held{dt, true, settings.regularisation};
  std::vector<Eigen::VectorXd> place = displacements(world), last_way;
  StepOutcome step;
  double slid = 0.;
  unsigned int near_balance = 0; // held steps since all walls have met what bears them
  for (sum.held_steps = 0; near_balance < settings.max_held_steps; ++sum.held_steps, ++near_balance)
  {
    step = held_step(world, held);
    add(step, sum);
    if (!step.accepted)
    {
      held.guess = nullptr; // it may be what failed
      held.regularisation *= 10.;
      if (held.regularisation > 10.)
        throw ComputationError("no balance is found with the walls at rest: " + step.reason);
      continue;
    }
    sum.largest_move = std::max(sum.largest_move, step.largest_move);
    const double before = of_bodies;
    of_bodies = unbalanced_force_here(world, dt);
    sum.unbalanced = std::max(of_bodies, unbalanced_walls(world));
    if (sum.unbalanced <= settings.unbalanced_force &&
        step.largest_move <= settings.held_motion * world.lattice->cell_size())
    {
      ++sum.held_steps;
      return sum;
    }
    std::vector<Eigen::VectorXd> now = displacements(world);
    for (unsigned int b = 0; b < now.size(); ++b)
      place[b] = now[b] - place[b];
    const double turn = last_way.empty() ? 0. : cosine(place, last_way);
    last_way.swap(place);
    place.swap(now);
    // In a cell they also go where it takes them, which is no guess for what they do beside that.
    held.guess = turn > 0.5 && !world.repeats() ? &last_way : nullptr;
    if (walls_are_on_their_way(world))
    {
      slid += slid_on_their_way(world, dt);
      check_room_of_walls(world, slid);
      near_balance = 0;
      continue;
    }
    // Back and forth: rows and bodies chase each other. On and on, or slow: what resists has no reason to.
    if (turn < -0.3)
      held.regularisation = std::min(10. * held.regularisation, 10.);
    else if (step.rows_settled && of_bodies > 0.3 * before)
      held.regularisation = std::max(0.1 * held.regularisation, 1e-3 * settings.regularisation);
  }
  if (settings.max_held_steps == 0)
    return sum;
  std::ostringstream message;
  message << "at time " << world.time << " s the bodies are not in balance after " << sum.held_steps
          << " held steps ('Quasi-static/Held steps'): unbalanced force " << sum.unbalanced
          << ", they still move by " << largest_move_in_cells(world, step) << " cells";
  throw ComputationError(message.str());
}
} // namespace

double unbalanced_force_here(World &world, const double dt)
{
  // With rows where the bodies are: those of the step may be some way off.
  world.find_rows(world.wall_motion({dt, true, 0.}), dt, nullptr, 0., true);
  return unbalanced_force(world, dt);
}

double unbalanced_force(World &world, const double dt)
{
  const auto &rows = world.contact.contact_rows();
  const unsigned int components = world.contact.n_components();
  std::vector<Vector> net(world.bodies.size());
  std::map<std::tuple<unsigned int, unsigned int, unsigned int, PeriodicCell::Image>, Vector> pairs;
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    Vector force;
    for (unsigned int c = 0; c < components; ++c)
      force += world.contact.impulses()[r * components + c] / dt * rows[r].resultant(c);
    if (force.norm() == 0.)
      continue;
    net[rows[r].body] += force;
    if (rows[r].partner != ContactRow<2>::none)
      net[rows[r].partner] -= force;
    const bool swapped = rows[r].partner < rows[r].body;
    const PeriodicCell::Image &n = rows[r].image;
    pairs[{std::min(rows[r].body, rows[r].partner), std::max(rows[r].body, rows[r].partner), rows[r].wall,
           swapped ? PeriodicCell::Image{{-n[0], -n[1]}} : n}] += swapped ? -force : force;
  }
  double mean = 0., worst = 0., floor = 0.;
  for (const auto &pair : pairs)
    mean += pair.second.norm() / pairs.size();
  Eigen::VectorXd load;
  for (Body<2> &body : world.bodies)
    if (!body.driven)
    {
      if (external_force(body, world.scene.gravity, world.time, load))
        for (unsigned int i = 0; i < body.mass.size(); ++i)
          net[body.index] += Vector({load[2 * i], load[2 * i + 1]});
      worst = std::max(worst, net[body.index].norm());
      floor = std::max(floor, 1e-6 * body.law->young_modulus() * world.lattice->cell_size());
    }
  return worst / std::max(mean, floor);
}

StepOutcome quasi_static_step(World &world, const double dt, const double wanted)
{
  StepOutcome sum = implicit_step(world, {dt, false, world.settings.regularisation * wanted / dt});
  // Walls under pressure go as far as balance lets them.
  if (!sum.accepted || world.contact.free_walls.list.empty())
    return sum;
  const StepOutcome held = find_balance(world, dt);
  if (held.held_steps > 0)
    add(held, sum);
  sum.held_steps = held.held_steps;
  sum.unbalanced = held.unbalanced;
  sum.largest_move = std::max(sum.largest_move, held.largest_move);
  return sum;
}

StepOutcome find_balance(World &world, const double dt)
{
  const double before = not_booked(world);
  const StepOutcome outcome = make_held_steps(world, dt);
  if (outcome.held_steps > 0)
    world.balance.released_energy += before - not_booked(world);
  return outcome;
}
} // namespace softgrain::mpm
