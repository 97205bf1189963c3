// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/model/check_rays.h>

#include <string>

namespace softgrain::mpm
{
namespace
{
[[noreturn]] void refuse(const std::string &where)
{
  throw InputError("'Contact/Geometry' = 'rays' is not allowed " + where + "; choose 'surface'");
}

bool counts_negative_pivots(const LinearSolverSettings &solver)
{
  return solver.type.compare(0, 2, "cg") != 0 && solver.type.compare(0, 8, "trilinos") != 0;
}

bool has_rays(const std::string &scheme)
{
  return scheme == "quasi_static" || scheme == "moreau_jean";
}
} // namespace

bool rays_serve(const Settings &settings)
{
  return has_rays(settings.scheme.name) && settings.coupling == ContactCoupling::condensed &&
         counts_negative_pivots(settings.linear_solver);
}

void check_rays(const Settings &settings)
{
  const std::string &scheme = settings.scheme.name;
  if (!has_rays(scheme))
    refuse("with 'Time/Scheme' = '" + scheme + "': it needs 'quasi_static' or 'moreau_jean'");
  if (settings.coupling != ContactCoupling::condensed)
    refuse("with 'Contact/Solver' = 'lumped'");
  if (!counts_negative_pivots(settings.linear_solver))
    refuse("with 'Linear solver/Type' = '" + settings.linear_solver.type +
           "', which cannot count negative pivots");
}
} // namespace softgrain::mpm
