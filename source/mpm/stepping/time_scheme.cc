// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/mpm/stepping/time_scheme.h>

namespace softgrain::mpm
{
std::vector<std::string> TimeScheme::names()
{
  return {"moreau_jean", "newmark", "explicit", "quasi_static"};
}

TimeScheme TimeScheme::create(const std::string &name, const double theta)
{
  if (!(theta >= 0.5 && theta <= 1.))
    throw InputError("'Time/Theta' = " + std::to_string(theta) +
                     " is not allowed: a number from 0.5 to 1 is needed");
  if (name == "moreau_jean")
    return {name, theta, true, true, false, 0.5, true};
  if (name == "newmark")
    return {name, 0.5, true, true, true};
  if (name == "explicit")
    return {name, 1., true, false, false};
  if (name == "quasi_static")
    return {name, 1., false, true, false, 1., true};
  throw InputError("'Time/Scheme' = '" + name + "' is not known; known are: " + join(names()));
}
} // namespace softgrain::mpm
