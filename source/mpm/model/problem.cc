// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/model/problem.h>
#include <softgrain/scene/contact_law.h>

namespace softgrain::mpm
{
SubgridCompliance Problem::subgrid() const
{
  return {settings.subgrid_compliance() && places_are_free() && !pairs.adhere(), lattice->cell_size(),
          lattice->lower()};
}

bool Problem::places_are_free() const
{
  return slippery() || (!settings.scheme.inertia && !contacts_remember());
}

bool Problem::places_slide() const
{
  return slippery() && settings.scheme.inertia && settings.rows_follow();
}

bool Problem::slippery() const
{
  return pairs.frictionless() && !contacts_remember() && !rough(scene.obstacles);
}

bool Problem::outlines_everywhere() const
{
  return !settings.meets_by_rays() && (!settings.condenses() || !geometry->looks_by_body());
}

bool Problem::contacts_remember() const
{
  return pairs.adhere() && scene.contact_law && scene.contact_law->remembers();
}
} // namespace softgrain::mpm
