// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
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
/// Shear strain, q/p and packing fraction after a step: what is kept of every step in the window.
constexpr std::size_t n_numbers = 3;

/// Means over a part of the window, by strain.
struct Means
{
  double ratio = 0., packing = 0., weight = 0.;

  void add(const double *sample, const double strain)
  {
    ratio += strain * sample[1];
    packing += strain * sample[2];
    weight += strain;
  }
};

/// q/p and the packing fraction no longer drift while the box is sheared.
class SteadyStateReached final : public StopCondition
{
public:
  std::string key() const override { return "Steady state"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(key(), "0", dealii::Patterns::Double(0),
                      "The run ends when the means of q/p, and those of the packing fraction, over the two "
                      "halves of the last 'Steady window' of shear strain differ by at most this; 0: no such "
                      "condition. Units: none.");
    prm.declare_entry("Steady window", "0.2", dealii::Patterns::Double(1e-300),
                      "With 'Steady state': shear strain over which is looked back. Units: none.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm) override
  {
    window = prm.get_double("Steady window");
  }

  bool depends_on_bodies() const override { return true; }

  std::string in_words(const double limit) const override
  {
    return "steady within " + number_in_words(limit) + " over a shear strain of " + number_in_words(window);
  }

  void check(const Scene<2> &scene, const double) const override
  {
    need_walls(scene, key(), {"bottom", "top", "left", "right"});
  }

  void note(const RunState &state, const double, std::vector<double> &memory) const override
  {
    const std::vector<WallState<2>> walls = state.model.walls();
    const std::optional<BoxStrain> strain = box_strain(state.walls_at_start, walls);
    const std::optional<BoxStress> stress = box_stress(walls);
    if (!strain || !stress || !(stress->mean() > 0.))
      return;
    memory.insert(memory.end(), {strain->shear(), stress->deviator() / stress->mean(),
                                 packing_fraction(walls, state.model.solid_area()).value_or(0.)});
    // Whatever is older than the window is forgotten, but for the one sample that still reaches into it.
    std::size_t first = 0;
    while (first + n_numbers < memory.size() && way(memory, first + n_numbers) >= window)
      first += n_numbers;
    memory.erase(memory.begin(), memory.begin() + first);
  }

  double fraction_done(const RunState &state, const double limit) const override
  {
    const std::vector<double> &memory = *state.memory;
    if (memory.size() < 3 * n_numbers)
      return 0.;
    const double seen = way(memory, 0);
    if (seen < window)
      return std::min(0.5, 0.5 * seen / window);
    Means early, late;
    for (std::size_t i = n_numbers; i < memory.size(); i += n_numbers)
      (way(memory, i) >= 0.5 * window ? early : late)
          .add(&memory[i], std::abs(memory[i] - memory[i - n_numbers]));
    if (!(early.weight > 0.) || !(late.weight > 0.))
      return 0.5;
    const double drift = std::max(std::abs(late.ratio / late.weight - early.ratio / early.weight),
                                  std::abs(late.packing / late.weight - early.packing / early.weight));
    return drift <= limit ? 1. : std::max(0.5, std::min(0.99, limit / drift));
  }

private:
  /// Shear strain between sample @p i and the last.
  static double way(const std::vector<double> &memory, const std::size_t i)
  {
    return std::abs(memory[memory.size() - n_numbers] - memory[i]);
  }

  double window = 0.;
};

[[maybe_unused]] const bool registered =
    Registry<StopCondition>::instance().add("steady_state",
                                            "stress ratio and packing no longer drift",
                                            [] { return std::make_unique<SteadyStateReached>(); });
} // namespace
} // namespace softgrain
