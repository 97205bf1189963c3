// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/model/check_rays.h>

namespace softgrain::mpm
{
bool rays_serve(const Settings &settings)
{
  return settings.coupling == ContactCoupling::condensed || !settings.scheme.implicit;
}

void check_rays(const Settings &settings)
{
  if (!rays_serve(settings))
    throw InputError("'Contact/Geometry' = 'rays' is not allowed with 'Contact/Solver' = 'lumped'; choose "
                     "'surface' or 'nodes'");
}
} // namespace softgrain::mpm
