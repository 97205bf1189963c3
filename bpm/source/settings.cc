// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/bpm/settings.h>
#include <softgrain/driving/contact_settings.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace softgrain::bpm
{
namespace
{
/// A strength that is none at some place of a disk would be found only when its bodies have been made.
void check_strength(const std::string &text)
{
  const std::string what = "'Primaries/Strength' = '" + text + "'";
  try
  {
    const Expression strength(text, {"x", "y", "r"});
    for (double x = -1.; x < 1.01; x += 0.1)
      for (double y = -1.; y < 1.01; y += 0.1)
      {
        const double r = std::hypot(x, y), value = strength({x, y, r});
        if (r <= 1. && (!(value >= 0.) || !std::isfinite(value)))
          throw InputError("it must be 0 or more everywhere in a body, and is " + std::to_string(value) +
                           " at r = " + std::to_string(r));
      }
  }
  catch (const InputError &error)
  {
    throw InputError(what + " is not allowed: " + error.what());
  }
}

using dealii::Patterns::Bool;
using dealii::Patterns::Double;
using dealii::Patterns::Integer;

void declare_primaries(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Primaries");
  SizeDistribution::declare_parameters(prm, "1e-4", "2e-4");
  prm.declare_entry("Number per body", "0", Integer(0),
                    "Primaries per body. 0: as many as fill its shape. With a number, the body keeps the "
                    "form of its shape but becomes smaller or larger. Units: none.");
  prm.declare_entry("Seed", "1", Integer(0), "Seed of the random sizes and places. Units: none.");
  prm.declare_entry(
      "Variants", "0", Integer(0),
      "Number of different fillings for bodies of the same shape and size, which are used in turn, so that "
      "large assemblies of equal grains are prepared sooner. 0: the first hundred bodies of the same form "
      "have their own, "
      "and those after them the same hundred in turn. Units: none.");
  prm.declare_entry(
      "Strength", "1", dealii::Patterns::Anything(),
      "Attraction of a primary over that of its law, a formula of its place in the body: x and y "
      "from the centre, r = sqrt(x^2 + y^2), all over the radius of the disk of the same area. A "
      "pair has the mean of its two. Units: none.");
  prm.declare_entry(
      "Strength spread", "0", Double(0., 0.99),
      "Attraction in whole bodies differs by random factors between 1 less this and 1 plus this. "
      "Units: none.");
  prm.declare_entry("Library", "", dealii::Patterns::Anything(),
                    "File (CSV) in which prepared aggregates are kept for the next run; empty: none.");
  prm.leave_subsection();
}

void declare_time(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Time");
  StepSettings::declare_parameters(
      prm,
      "'Step fraction' times sqrt(m a0 / F0), the time in which attraction moves a primary by its diameter",
      "1e-3");
  prm.declare_entry("Step fraction", "0.1", Double(1e-6, 10.),
                    "Length of a step over the time sqrt(m a0 / F0), when 'Time step' is 0. Units: none.");
  prm.leave_subsection();
}

void declare_contact(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Contact");
  prm.declare_entry(
      "Rolling resistance", "0", Double(0.),
      "Coefficient mu_r of (2.12) between primaries of different bodies and at walls. Without it friction "
      "hardly "
      "acts on bonded bodies, for their primaries roll; from 1 on it acts wholly. Units: none.");
  prm.declare_entry(
      "Inner rolling resistance", "0", Double(0.),
      "Coefficient mu_r of (2.12) between primaries of one body; between bodies friction needs it too. "
      "Units: none.");
  prm.declare_entry("Restitution", "0", Double(0., 1.),
                    "Coefficient of normal restitution of all contacts. Units: none.");
  prm.declare_entry("Gap correction", "1", Double(0., 1.),
                    "Share of an overlap that a step pushes out. Units: none.");
  prm.declare_entry("Range", "0.02", Double(0., 1.),
                    "Pairs with a gap below this are passed to the contact solver, and so are all pairs that "
                    "may close within the step. Units: mean diameters.");
  prm.declare_entry("Skin", "0.3", Double(0.001, 10.),
                    "Neighbours are searched again when two primaries may have moved by this distance. "
                    "Units: mean diameters.");
  prm.declare_entry(
      "Largest penetration", "0.02", Double(1e-6, 1.),
      "A step that leaves a larger overlap is repeated with half its length. Units: mean diameters.");
  ContactSettings::declare_parameters(
      prm, "1e-3", {{"accelerated", "sweeps with momentum and restart"}, {"gauss_seidel", "plain sweeps"}});
  prm.declare_entry(
      "Wall tolerance", "0.03", Double(1e-14, 1.),
      "Largest estimated error of the forces on walls, relative to the largest of them. Units: none.");
  prm.declare_entry(
      "Wall floor", "0.03", Double(0.),
      "The largest force on a wall counts as no less than this in 'Wall tolerance', so that bodies which "
      "have "
      "hardly met cost few sweeps. Units: F0/<a0> times the side of the square that has the area of all "
      "primaries.");
  prm.declare_entry(
      "Penetration tolerance", "1e-4", Double(1e-14, 1.),
      "Largest overlap that the error of a contact solution may add in one step. Units: mean diameters.");
  prm.leave_subsection();
  prm.enter_subsection("Output");
  prm.declare_entry("Inner forces", "true", Bool(),
                    "Whether forces between primaries of one body go into pictures and snapshots.");
  prm.leave_subsection();
}
} // namespace

void Settings::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_primaries(prm);
  declare_time(prm);
  declare_contact(prm);
}

void Settings::parse_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Primaries");
  primaries.sizes.parse_parameters(prm, "Primaries");
  primaries.number = prm.get_integer("Number per body");
  primaries.seed = prm.get_integer("Seed");
  primaries.variants = prm.get_integer("Variants");
  primaries.strength = prm.get("Strength");
  check_strength(primaries.strength);
  primaries.strength_spread = prm.get_double("Strength spread");
  primaries.aggregate_file = prm.get("Library");
  prm.leave_subsection();

  prm.enter_subsection("Time");
  step.parse_parameters(prm);
  step_fraction = prm.get_double("Step fraction");
  prm.leave_subsection();

  prm.enter_subsection("Contact");
  dynamics.rolling_resistance = prm.get_double("Rolling resistance");
  dynamics.inner_rolling_resistance = prm.get_double("Inner rolling resistance");
  dynamics.restitution = prm.get_double("Restitution");
  dynamics.gap_correction = prm.get_double("Gap correction");
  dynamics.contact_range = prm.get_double("Range");
  dynamics.skin = prm.get_double("Skin");
  dynamics.solver_penetration = prm.get_double("Penetration tolerance");
  largest_penetration = prm.get_double("Largest penetration");
  ContactSettings common;
  common.parse_parameters(prm);
  dynamics.solver.tolerance = common.tolerance;
  dynamics.solver.wall_tolerance = prm.get_double("Wall tolerance");
  wall_floor = prm.get_double("Wall floor");
  dynamics.solver.max_sweeps = common.max_sweeps;
  dynamics.solver.relaxation = common.relaxation;
  dynamics.solver.algorithm = common.algorithm == "accelerated" ? contact::DiskAlgorithm::accelerated
                                                                : contact::DiskAlgorithm::gauss_seidel;
  prm.leave_subsection();

  prm.enter_subsection("Output");
  inner_contacts_in_output = prm.get_bool("Inner forces");
  prm.leave_subsection();
}
} // namespace softgrain::bpm
