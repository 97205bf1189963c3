// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/mpm/model/step_choice.h>
#include <softgrain/mpm/stepping/time_integrator.h>
#include <softgrain/parameters/within_section.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Way of the fastest wall in a step [cells].
constexpr double usual_wall_way = 0.1;
/// Steps that resolve what bodies do by themselves [CFL steps].
constexpr double usual_cfl_multiple = 20.;

/// Takes steps by the way of walls where the file gives none.
void choose_steps(Settings &settings)
{
  // Without inertia there are no waves.
  const bool by_waves = settings.cfl_multiple > 0. && !settings.scheme.ends_in_balance();
  if (settings.cfl_multiple == 0.)
    settings.cfl_multiple = usual_cfl_multiple;
  if (by_waves || settings.wall_way > 0. || settings.step.time_step > 0. ||
      !settings.scheme.solves_equations())
    return;
  settings.wall_way = usual_wall_way;
  settings.chosen_way = true;
}
} // namespace

void declare_time_parameters(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Double;
  using dealii::Patterns::Selection;
  const WithinSection time(prm, "Time");
  prm.declare_entry("Scheme", "moreau_jean", Selection(Registry<TimeIntegrator>::instance().choice()),
                    Registry<TimeIntegrator>::instance().choice_in_words());
  prm.declare_entry("Theta", "0", Double(0., 1.),
                    "Weight of the end of the step in moreau_jean: 0.5 conserves energy, 1 is backward "
                    "Euler. 0: 0.55, or 0.8 where the first step is longer than 20 CFL steps, so that waves "
                    "it does not resolve fade. Units: none.");
  StepSettings::declare_parameters(prm, "'Wall way', or 'CFL multiple' times the CFL step", "1e-4");
  prm.declare_entry("CFL multiple", "0", Double(0.),
                    "Length of a step in CFL steps (cell size over the speed of pressure waves), when "
                    "'Time step' is 0. 0: 20, for steps that 'Wall way' does not give. Units: none.");
  prm.declare_entry(
      "Wall way", "0", Double(0., 10.),
      "Steps by the way of the walls: how far the fastest of those that are told how to move goes in a step, "
      "in cells: 0.1 to 0.3. 'Time step', if given, is then the longest step. While no wall moves so: 'Time "
      "step' or 'CFL multiple'. 0: 0.1 if neither of these is given, or without inertia only the last; with "
      "inertia no longer than 20 CFL "
      "steps where loads, velocities at the start, obstacles or stresses on walls move bodies too. Units: "
      "cells.");
}

void parse_time_parameters(dealii::ParameterHandler &prm, Settings &settings)
{
  const WithinSection time(prm, "Time");
  settings.theta = prm.get_double("Theta");
  settings.scheme = TimeScheme::create(prm.get("Scheme"), settings.theta == 0. ? 0.55 : settings.theta);
  settings.step.parse_parameters(prm);
  settings.cfl_multiple = prm.get_double("CFL multiple");
  settings.wall_way = prm.get_double("Wall way");
  if (settings.wall_way > 0. && !settings.scheme.solves_equations())
    throw InputError("'Time/Wall way' = '" + prm.get("Wall way") + "' is not allowed with 'Time/Scheme' = '" +
                     settings.scheme.name + "', whose steps waves limit: leave it at 0");
  choose_steps(settings);
}

bool all_are_told(const std::vector<Wall<2>> &walls)
{
  return std::none_of(walls.begin(), walls.end(), [](const Wall<2> &wall) { return is_free(wall); });
}
} // namespace softgrain::mpm
