// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_obstacle_line_h
#define softgrain_mpm_contact_obstacle_line_h

#include <softgrain/driving/obstacle.h>
#include <softgrain/geometry/line_surface.h>
#include <softgrain/mpm/contact/near_stretches.h>
#include <softgrain/mpm/contact/ray.h>

namespace softgrain::mpm
{
/// The line of an obstacle, as rays meet it in the step that is planned for it.
class ObstacleLine
{
public:
  explicit ObstacleLine(const Obstacle<2> &obstacle);

  /// Both sides, where they are at the start of the step. @param spacing of the samples, at most [m]
  SampledSurface<2> samples(double spacing) const;

  /// Where a ray meets it @p share of the step after its start. Places are those of the drawn line.
  RaySide<2> meet(const Ray<2> &ray, double share, const SurfacePlace<2> &guess) const;

  dealii::Point<2> placed(const SurfacePlace<2> &place, const double share) const
  {
    return way.at(share).placed(place.position);
  }
  /// Way of a place over the step [m].
  dealii::Tensor<1, 2> way_of(const SurfacePlace<2> &place) const { return way.way_of(place.position); }
  double largest_way() const; ///< [m]

  const double friction;
  const LineSurface surface;
  const ObstacleMotion<2> way;
};

/// A line's surface as it is drawn.
LineSurface surface_of(const Obstacle<2> &obstacle);
} // namespace softgrain::mpm

#endif
