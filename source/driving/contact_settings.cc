// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/driving/contact_settings.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
void ContactSettings::declare_parameters(dealii::ParameterHandler &prm,
                                         const std::string &tolerance,
                                         const std::vector<Choice> &algorithms)
{
  using namespace dealii::Patterns;
  prm.declare_entry(
      "Tolerance", tolerance, Double(1e-14, 1.),
      "Largest residual of a contact solution (natural map), relative to the approach speed. Units: none.");
  prm.declare_entry("Maximum sweeps", "20000", Integer(1),
                    "Largest number of Gauss-Seidel sweeps of one contact solve. Units: none.");
  prm.declare_entry("Relaxation", "1", Double(0.05, 1.95),
                    "With 'Algorithm = gauss_seidel': factor on every change of an impulse. Units: none.");
  std::string choice, meaning;
  for (const Choice &algorithm : algorithms)
  {
    choice += (choice.empty() ? "" : "|") + algorithm.name;
    meaning += (meaning.empty() ? "" : "; ") + algorithm.name + ": " + algorithm.meaning;
  }
  prm.declare_entry("Algorithm", algorithms.front().name, Selection(choice), meaning + ".");
}

void ContactSettings::parse_parameters(const dealii::ParameterHandler &prm)
{
  tolerance = prm.get_double("Tolerance");
  max_sweeps = prm.get_integer("Maximum sweeps");
  relaxation = prm.get_double("Relaxation");
  algorithm = prm.get("Algorithm");
  if (relaxation != 1. && algorithm != "gauss_seidel")
    throw InputError(
        "'Contact/Relaxation' = '" + prm.get("Relaxation") +
        "' is for plain sweeps only: leave it at 1, or set 'Contact/Algorithm' = 'gauss_seidel'");
}

std::vector<std::string> ContactSettings::names()
{
  return {"Contact/Tolerance", "Contact/Maximum sweeps", "Contact/Relaxation", "Contact/Algorithm"};
}
} // namespace softgrain
