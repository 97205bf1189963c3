// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/problem.h>

#include <cmath>
#include <string>

namespace softgrain::contact
{
void Problem::check() const
{
  if (n_components < 1 || n_components > 3)
    throw InputError("a contact has 1, 2 or 3 components, not " + std::to_string(n_components));
  if (free_velocity.size() % n_components != 0)
    throw InputError("contact problem: " + std::to_string(free_velocity.size()) +
                     " free velocities do not make whole contacts of " + std::to_string(n_components) +
                     " components");
  if (n_components > 1 && friction.size() != n_contacts())
    throw InputError("contact problem: " + std::to_string(friction.size()) + " friction coefficients for " +
                     std::to_string(n_contacts()) + " contacts");
  std::size_t colored = 0;
  for (const std::vector<Range> &color : colors)
    for (const Range &range : color)
      colored += range.end - range.first;
  if (!colors.empty() && colored != n_contacts())
    throw InputError("contact problem: colours hold " + std::to_string(colored) + " of " +
                     std::to_string(n_contacts()) + " contacts");
  if (!cohesion.empty() && cohesion.size() != n_contacts())
    throw InputError("contact problem: " + std::to_string(cohesion.size()) + " cohesive impulses for " +
                     std::to_string(n_contacts()) + " contacts");
  for (std::size_t i = 0; i < cohesion.size(); ++i)
  {
    if (!std::isfinite(cohesion[i]))
      throw ComputationError("contact " + std::to_string(i) + ": the cohesive impulse is not finite");
    if (cohesion[i] < 0.)
      throw InputError("contact " + std::to_string(i) + ": the cohesive impulse is negative (" +
                       std::to_string(cohesion[i]) + ")");
  }
  for (std::size_t i = 0; i < free_velocity.size(); ++i)
    if (!std::isfinite(free_velocity[i]))
      throw ComputationError("contact " + std::to_string(i / n_components) +
                             ": the free relative velocity is not finite");
  if (n_components > 1)
    for (std::size_t i = 0; i < friction.size(); ++i)
    {
      if (!std::isfinite(friction[i]))
        throw ComputationError("contact " + std::to_string(i) + ": the friction coefficient is not finite");
      if (friction[i] < 0.)
        throw InputError("contact " + std::to_string(i) + ": the friction coefficient is negative (" +
                         std::to_string(friction[i]) + ")");
    }
}
} // namespace softgrain::contact
