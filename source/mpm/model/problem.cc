// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/model/problem.h>
#include <softgrain/scene/contact_law.h>

namespace softgrain::mpm
{
SubgridCompliance Problem::subgrid() const
{
  return {settings.subgrid_compliance() && !pairs.adhere(), lattice->cell_size(), lattice->lower()};
}

bool Problem::slippery() const
{
  return pairs.frictionless() && !contacts_remember() && !rough(scene.obstacles);
}

bool Problem::contacts_remember() const
{
  return pairs.adhere() && scene.contact_law && scene.contact_law->remembers();
}
} // namespace softgrain::mpm
