// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/box.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain
{
namespace
{
/// Steps in a row in which the box grew, and its growth since the start, after which nobody waits for it to
/// close again where nothing else ends the run.
constexpr double most_growing = 1000., far_too_large = 4.;

class PackingFractionReached final : public StopCondition
{
public:
  std::string key() const override { return "Packing fraction"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(
        key(), "0", dealii::Patterns::Double(0),
        "The run ends when the bodies fill this share of the box of the walls bottom, top, left "
        "and right, in space front and back too; 0: no such condition. Units: none.");
  }

  std::string in_words(const double limit) const override
  {
    return "packing fraction " + number_in_words(limit);
  }

  void check(const Scene<2> &scene, const double) const override
  {
    need_walls(scene, key(), {"bottom", "top", "left", "right"});
  }

  void check_start(const Scene<2> &scene, const double limit) const override
  {
    double solid = 0.;
    for (const BodyDescription<2> &body : scene.bodies)
      solid += body.shape->area();
    check_fraction(solid / std::abs(box_of(scene.walls)->volume()), limit);
  }

  void note(const RunState &state, const double limit, std::vector<double> &memory) const override
  {
    // In a row: steps in which the box grew. Then the box.
    const double area = std::abs(box_of(state.model.walls())->volume());
    memory.resize(2, 0.);
    memory[0] = area > memory[1] && memory[1] > 0. ? memory[0] + 1. : 0.;
    memory[1] = area;
    if (state.ends_anyway || memory[0] < most_growing ||
        area < far_too_large * std::abs(box_of(state.walls_at_start)->volume()))
      return;
    std::ostringstream message;
    message << "at time " << state.model.time() << " s the packing fraction is "
            << packing_fraction(state.model.walls(), state.model.solid_area()).value_or(0.)
            << " and is to be " << limit << " ('Stop/" << key() << "'), but the walls have moved apart for "
            << memory[0] << " steps, to a box more than " << far_too_large
            << " times that of the start: drive them together, or set 'Stop/End time' too";
    throw ComputationError(message.str());
  }

  double fraction_done(const RunState &state, const double limit) const override
  {
    return part_of_way(state, limit);
  }

  bool works_in_space() const override { return true; }
  void check_in_space(const Scene<3> &scene, const double limit) const override
  {
    need_walls(scene, key(), {Box<3>::sides.begin(), Box<3>::sides.end()});
    double solid = 0.;
    for (const BodyDescription<3> &body : scene.bodies)
      solid += body.shape->volume();
    check_fraction(solid / std::abs(box_of(scene.walls)->volume()), limit);
  }
  double fraction_done_in_space(const RunStateIn<3> &state, const double limit) const override
  {
    return part_of_way(state, limit);
  }

private:
  /// @param fraction at the start
  void check_fraction(const double fraction, const double limit) const
  {
    if (fraction >= limit)
      throw InputError("'Stop/" + key() + "' = '" + number_in_words(limit) +
                       "' is already reached: the bodies fill " + number_in_words(fraction) +
                       " of the box at the start");
  }

  template <int dim>
  static double part_of_way(const RunStateIn<dim> &state, const double limit)
  {
    const double solid = state.model.solid_area();
    const double packing = packing_fraction(state.model.walls(), solid).value_or(0.);
    if (packing >= limit)
      return 1.;
    // The box shrinks like 1/packing: this measures the way of the walls.
    const double start = packing_fraction(state.walls_at_start, solid).value_or(packing);
    return packing > 0. ? std::max(0., (1. / start - 1. / packing) / (1. / start - 1. / limit)) : 0.;
  }
};

[[maybe_unused]] const bool registered =
    Registry<StopCondition>::instance().add("packing_fraction",
                                            "share of the box that bodies fill",
                                            [] { return std::make_unique<PackingFractionReached>(); });
} // namespace
} // namespace softgrain
