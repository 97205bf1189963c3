// SPDX-License-Identifier: LGPL-2.1-or-later
// Which rays a rigid thing has.
#include <softgrain/mpm/contact/obstacle_line.h>
#include <softgrain/mpm/contact/obstacle_solid.h>
#include <softgrain/mpm/contact/rigid_rays.h>

namespace softgrain::mpm
{
AllRigidRays<2> rays_of(const std::vector<Obstacle<2>> &obstacles, const double spacing)
{
  AllRigidRays<2> rays;
  for (const Obstacle<2> &obstacle : obstacles)
    rays.push_back(std::make_unique<ObstacleLine>(obstacle, spacing));
  return rays;
}

AllRigidRays<3> rays_of(const std::vector<Obstacle<3>> &obstacles, const std::vector<ObstacleMotion<3>> &ways)
{
  AllRigidRays<3> rays;
  for (std::size_t o = 0; o < obstacles.size(); ++o)
    rays.push_back(std::make_unique<ObstacleSolid>(obstacles[o], ways[o]));
  return rays;
}
} // namespace softgrain::mpm
