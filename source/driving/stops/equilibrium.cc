// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/assembly.h>
#include <softgrain/analysis/box_measures.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/box.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain
{
namespace
{
/// Above every limit, and a number: checkpoints hold nothing else.
constexpr double unknown = std::numeric_limits<double>::max();
constexpr std::size_t n_numbers = 4;

/// What is kept between steps.
struct Seen
{
  explicit Seen(const std::vector<double> &memory)
  {
    if (memory.size() == n_numbers)
      force = memory[0], energy = memory[1], failures = memory[2], next = memory[3];
  }

  double force = unknown, energy = unknown; ///< ratios, when last measured
  double failures = 0.;                     ///< of looks at the forces
  double next = 0.;                         ///< step of the next look
};

/// Stored energy that motion is compared with [J/m]: elastic, or, of bodies that attraction holds together,
/// whose energy is below zero, the pressure on the walls times the box.
double energy_scale(const Model<2> &model, const double elastic)
{
  if (elastic > 0.)
    return elastic;
  const std::vector<WallState<2>> walls = model.walls();
  const std::optional<BoxStress> stress = box_stress(walls);
  return stress ? std::abs(stress->mean()) * box_of(walls)->volume() : 0.;
}

/// Mean force on a body that its contacts and loads leave over, over the mean force of a contact.
double unbalanced_force(const Snapshot<2> &snapshot, const Loads<2> &loads, const double time)
{
  std::vector<dealii::Tensor<1, 2>> sum(snapshot.bodies.size());
  std::vector<bool> touched(snapshot.bodies.size(), false);
  const Assembly assembly(snapshot);
  double contact_force = 0.;
  for (const BodyContact &contact : assembly.contacts)
  {
    contact_force += contact.force.norm() / assembly.contacts.size();
    sum[contact.body_a] += contact.force;
    touched[contact.body_a] = true;
    if (!contact.with_wall())
    {
      sum[contact.body_b] -= contact.force;
      touched[contact.body_b] = true;
    }
  }
  if (!(contact_force > 0.))
    return unknown;
  double left_over = 0.;
  unsigned int n = 0;
  for (std::size_t b = 0; b < sum.size(); ++b)
    if (touched[b])
    {
      const auto &body = snapshot.bodies[b];
      const LoadPlace<2> place{body.center, body.center, body.velocity, time};
      left_over += (sum[b] + body.mass * loads.acceleration(place)).norm();
      ++n;
    }
  return left_over / n / contact_force;
}

/// Forces on bodies and free walls are balanced, and motion is small.
class EquilibriumReached final : public StopCondition
{
public:
  std::string key() const override { return "Equilibrium"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(
        key(), "0", dealii::Patterns::Double(0),
        "The run ends when the mean force that is left over on a body that touches others, over "
        "the mean contact force, and that on a free wall, over its load, are at most this, and "
        "motion is as small as 'Equilibrium energy' says; 0: no such condition. Units: none.");
    prm.declare_entry("Equilibrium energy", "1e-4", dealii::Patterns::Double(1e-300),
                      "With 'Equilibrium': largest kinetic energy over the elastic one; of bonded primaries "
                      "over the mean pressure on the walls times the area of the box. Units: none.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm) override
  {
    energy_limit = prm.get_double("Equilibrium energy");
  }

  bool depends_on_bodies() const override { return true; }

  std::string in_words(const double limit) const override
  {
    return "forces balanced within " + number_in_words(limit);
  }

  void check(const Scene<2> &scene, const double) const override
  {
    for (const BodyDescription<2> &body : scene.bodies)
      if (body.driven || body.body_force.find_first_not_of("0.,; ") != std::string::npos)
        throw InputError("'Stop/" + key() + "' cannot be measured: body '" + body.name +
                         "' is driven or has a 'Body force'");
  }

  void note(const RunState &state, const double limit, std::vector<double> &memory) const override
  {
    Seen seen(memory);
    const Energies energies = state.model.energies();
    const double scale = energy_scale(state.model, energies.elastic);
    seen.energy = scale > 0. ? energies.kinetic / scale : unknown;
    // Forces cost a snapshot: only when all else is balanced, and less and less often where that is no use.
    const double walls = state.model.unbalanced_walls();
    if (seen.energy > energy_limit || walls > limit)
      seen.force = unknown;
    else if (state.model.step() >= seen.next)
    {
      seen.force = std::max(walls, unbalanced_force(state.model.snapshot(), state.loads, state.model.time()));
      seen.failures = std::min(seen.failures + 1., 10.);
      seen.next = state.model.step() + seen.failures;
    }
    memory = {seen.force, seen.energy, seen.failures, seen.next};
  }

  double fraction_done(const RunState &state, const double limit) const override
  {
    const Seen seen(*state.memory);
    if (seen.force <= limit && seen.energy <= energy_limit)
      return 1.;
    return seen.force < unknown ? std::min(0.99, limit / seen.force) : 0.;
  }

private:
  double energy_limit = 0.;
};

[[maybe_unused]] const bool registered =
    Registry<StopCondition>::instance().add("equilibrium",
                                            "forces are balanced and hardly anything moves",
                                            [] { return std::make_unique<EquilibriumReached>(); });
} // namespace
} // namespace softgrain
