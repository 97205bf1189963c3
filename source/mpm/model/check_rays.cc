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
} // namespace

void check_rays(const Settings &settings)
{
  if (settings.scheme.name != "quasi_static" && settings.scheme.name != "moreau_jean")
    refuse("with 'Time/Scheme' = '" + settings.scheme.name + "': it needs 'quasi_static' or 'moreau_jean'");
  if (settings.coupling != ContactCoupling::condensed)
    refuse("with 'Contact/Solver' = 'lumped'");
  if (const std::string &type = settings.linear_solver.type;
      type.compare(0, 2, "cg") == 0 || type.compare(0, 8, "trilinos") == 0)
    refuse("with 'Linear solver/Type' = '" + type + "', which cannot count negative pivots");
}
} // namespace softgrain::mpm
