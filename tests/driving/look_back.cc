// SPDX-License-Identifier: LGPL-2.1-or-later
// Stop conditions that look back, on made-up states: q/p = 0.3 (1 - exp(-e/0.1)) is steady within 0.01 over a
// window of 0.2 from e = 0.1 ln(30 (exp(1) - 1)^2) = 0.4484 on; two disks in a chain whose forces differ by d
// leave over d / (1 - d/3) of the mean contact force.
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/model/memory_state.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
/// Shows what it is told to.
class Shown : public Model<2>
{
public:
  Snapshot<2> state;
  Energies energy;
  double walls_left_over = 0.;
  unsigned int steps = 0;
  mutable unsigned int snapshots = 0;

  std::string name() const override { return "shown"; }
  StepReport advance(double) override { return {}; }
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &) override {}
  double time() const override { return steps; }
  std::size_t step() const override { return steps; }
  Snapshot<2> snapshot() const override
  {
    ++snapshots;
    return state;
  }
  std::vector<WallState<2>> walls() const override { return state.walls; }
  double unbalanced_walls() const override { return walls_left_over; }
  Energies energies() const override { return energy; }
  double solid_area() const override { return 0.8; }
  double coordination() const override { return 0.; }
  double momentum_error() const override { return 0.; }
  std::size_t n_points() const override { return 0; }
  std::size_t n_bodies() const override { return state.bodies.size(); }
  SizeReport size_report() const override { return {}; }
  std::map<std::string, double> phases() const override { return {}; }
  void save(StateWriter &) const override {}
  void load(StateReader &) override {}
};

std::vector<WallState<2>> box(const double width, const double height, const double s1, const double s2)
{
  std::vector<WallState<2>> walls(4);
  const char *const names[] = {"bottom", "top", "left", "right"};
  for (unsigned int w = 0; w < 4; ++w)
  {
    walls[w].name = names[w];
    walls[w].normal[w < 2 ? 1 : 0] = w % 2 == 0 ? 1. : -1.;
    walls[w].normal_force = w < 2 ? s1 * width : s2 * height;
  }
  walls[1].point[1] = height;
  walls[3].point[0] = width;
  return walls;
}

StopConditions conditions(const std::vector<std::pair<std::string, std::string>> &set)
{
  dealii::ParameterHandler prm;
  StopConditions::declare_parameters(prm);
  prm.enter_subsection("Stop");
  for (const auto &[key, value] : set)
    prm.set(key, value);
  prm.leave_subsection();
  StopConditions stop;
  stop.parse_parameters(prm);
  return stop;
}

/// Shear strain at which it ends; @p broken: what it remembers goes through a checkpoint on the way.
double end_of_shear(const StopConditions &stop, const bool broken)
{
  Shown model;
  const std::vector<WallState<2>> start = box(1., 1., 1., 1.);
  StopMemory memory;
  for (int i = 1; i <= 2000; ++i)
  {
    const double strain = 5e-4 * i, ratio = 0.3 * (1. - std::exp(-strain / 0.1));
    model.state.walls = box(std::exp(strain / 2.), std::exp(-strain / 2.), 1. + ratio, 1. - ratio);
    ++model.steps;
    const Loads<2> none;
    const RunState state{model, start, none};
    stop.note(state, memory);
    if (broken && i == 500)
    {
      MemoryState file;
      save(file, "seen", memory);
      memory = load_stop_memory(file, "seen");
    }
    if (stop.fraction_done(state, memory) >= 1.)
      return strain;
  }
  return 0.;
}

/// Two disks between bottom and top, the force on the upper one smaller by @p difference.
Shown chain(const double difference)
{
  Shown model;
  model.state.walls = box(1., 2., 1., 0.);
  const double force[] = {1., 1. - difference, 1.};
  for (unsigned int b = 0; b < 2; ++b)
  {
    BodyState<2> body;
    body.center = dealii::Point<2>(0.5, 0.5 + b);
    body.mass = 0.1;
    model.state.bodies.push_back(body);
  }
  for (unsigned int c = 0; c < 3; ++c)
  {
    ContactState<2> contact;
    contact.body_a = c == 0 ? 0 : 1;
    if (c == 1)
      contact.body_b = 0;
    else
      contact.wall = c == 0 ? 0 : 1;
    contact.normal[1] = c == 2 ? -1. : 1.;
    contact.force = force[c] * contact.normal;
    contact.place = dealii::Point<2>(0.5, c);
    model.state.contacts.push_back(contact);
  }
  model.energy.elastic = 1.;
  return model;
}

/// Pulls down by 1 N/kg.
class Weight final : public Load<2>
{
public:
  std::string key() const override { return "Weight"; }
  void declare_parameters(dealii::ParameterHandler &) const override {}
  void parse_parameters(dealii::ParameterHandler &) override {}
  bool acts() const override { return true; }
  bool is_uniform() const override { return true; }
  dealii::Tensor<1, 2> acceleration(const LoadPlace<2> &) const override
  {
    return dealii::Tensor<1, 2>({0., -1.});
  }
};

void balance(const std::string &what, const Shown &model, const Loads<2> &loads = {})
{
  const StopConditions stop = conditions({{"Equilibrium", "0.01"}, {"Equilibrium energy", "1e-3"}});
  StopMemory memory;
  const RunState state{model, model.state.walls, loads};
  stop.note(state, memory);
  const double done = stop.fraction_done(state, memory);
  std::cout << what << ": " << done;
  if (done > 0.)
    std::cout << ", left over " << memory.at("Equilibrium")[0];
  std::cout << "; snapshots " << model.snapshots;
  for (const double kept : memory.at("Equilibrium"))
    if (!std::isfinite(kept)) // checkpoints refuse it
      std::cout << "; what is kept is no number";
  std::cout << '\n';
}
} // namespace

int main()
{
  const StopConditions steady = conditions({{"Steady state", "0.01"}, {"Steady window", "0.2"}});
  std::cout << steady.in_words() << " at " << end_of_shear(steady, false) << '\n'
            << "through a checkpoint the same: "
            << (end_of_shear(steady, true) == end_of_shear(steady, false) ? "yes" : "no") << '\n';

  std::cout << conditions({{"Equilibrium", "0.01"}}).in_words() << '\n';
  balance("balanced", chain(0.));
  balance("nearly", chain(0.009));
  balance("not", chain(0.03));
  // The lower disk is pushed up by 0.1 and the upper one down: weight mends the one and spoils the other.
  Loads<2> weight;
  weight.add(std::make_shared<Weight>());
  balance("with weight", chain(0.1), weight);
  Shown other = chain(0.);
  other.walls_left_over = 0.5;
  balance("a wall is not", other);
  other = chain(0.);
  other.energy.kinetic = 2e-3;
  balance("moving", other);
  // Attraction: energy below zero. The mean pressure is 0.5 Pa, the box 2 m^2.
  other.energy.elastic = -1.;
  balance("moving, bonded", other);
  other.energy.kinetic = 0.5e-3;
  balance("hardly moving, bonded", other);
  other = chain(0.);
  other.state.contacts.clear();
  balance("nothing touches", other);
}
