// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/wall_freedom.h>

#include <algorithm>
#include <limits>

namespace softgrain
{
bool is_free(const Wall<2> &wall)
{
  return is_free(wall, Freedom::along) || is_free(wall, Freedom::across);
}

std::vector<Freedom> freedoms_of(const Wall<2> &wall)
{
  std::vector<Freedom> freedoms;
  for (const Freedom direction : {Freedom::along, Freedom::across})
    if (is_free(wall, direction))
      freedoms.push_back(direction);
  return freedoms;
}

dealii::Tensor<1, 2> way_of(const Wall<2> &wall, const Freedom direction)
{
  return direction == Freedom::along ? wall.tangent() : wall.normal();
}

const WallLoad &load_on(const Wall<2> &wall, const Freedom direction)
{
  return direction == Freedom::along ? wall.free.along : wall.free.across;
}

double &speed_of(Wall<2> &wall, const Freedom direction)
{
  return direction == Freedom::along ? wall.slide_speed : wall.speed;
}

double speed_of(const Wall<2> &wall, const Freedom direction)
{
  return direction == Freedom::along ? wall.slide_speed : wall.speed;
}

double asked_stress(const std::vector<Wall<2>> &walls,
                    const std::size_t w,
                    const Freedom direction,
                    const double time,
                    const double dt)
{
  return direction == Freedom::along ? demanded_shear(walls[w], time, dt)
                                     : asked_pressure(walls, w, time, dt);
}

void put_stress(std::vector<Wall<2>> &walls,
                const std::size_t w,
                const Freedom direction,
                const double time,
                const double dt,
                const double share_of_damping)
{
  const double asked = asked_stress(walls, w, direction, time, dt), length = pressed_length(walls, w);
  if (direction == Freedom::along)
    put_shear(walls[w], asked, length);
  else
    put_pressure(walls[w], asked, length, share_of_damping);
}

FreeWallStep free_step(
    const Wall<2> &wall, const Freedom direction, const double dt, const double theta, const double impulse)
{
  return direction == Freedom::along ? free_slide_step(wall, dt, theta, impulse)
                                     : free_wall_step(wall, dt, theta, impulse);
}

WallAhead ahead_of(const Wall<2> &wall, const double dt, const double theta)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  WallAhead ahead{{infinite, wall.slide_speed}, {infinite, wall.speed}};
  if (is_free(wall, Freedom::along))
    ahead.along = free_step(wall, Freedom::along, dt, theta);
  if (is_free(wall, Freedom::across))
    ahead.across = free_step(wall, Freedom::across, dt, theta);
  return ahead;
}

dealii::Tensor<1, 2> WallAhead::velocity(const Wall<2> &wall) const
{
  const dealii::Tensor<1, 2> by_normal = across.free_speed * wall.normal();
  return along.free_speed == 0. ? by_normal : by_normal + along.free_speed * wall.tangent();
}

WallRates told_rates(const Wall<2> &wall, const double time, const double dt)
{
  return {is_free(wall, Freedom::across) ? 0. : demand_of(wall, time, dt).velocity,
          is_free(wall, Freedom::along) ? 0. : demanded_slide(wall, time, dt)};
}

WallRates expected_rates(const Wall<2> &wall, const double time, const double dt)
{
  WallRates rates = told_rates(wall, time, dt);
  if (is_free(wall, Freedom::across))
    rates.speed = wall.speed;
  if (is_free(wall, Freedom::along))
    rates.slide = wall.slide_speed;
  return rates;
}
} // namespace softgrain
