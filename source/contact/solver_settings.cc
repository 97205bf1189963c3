// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/gauss_seidel.h>

#include <cmath>
#include <string>

namespace softgrain::contact
{
void SolverSettings::check() const
{
  if (!(tolerance > 0.) || !std::isfinite(tolerance))
    throw InputError("contact solver: the tolerance must be positive, not " + std::to_string(tolerance));
  if (!(relaxation > 0. && relaxation < 2.))
    throw InputError("contact solver: the relaxation must be between 0 and 2, not " +
                     std::to_string(relaxation));
  if (check_interval == 0)
    throw InputError("contact solver: the check interval must be at least 1");
}
} // namespace softgrain::contact
