// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_obstacle_solid_h
#define softgrain_mpm_contact_obstacle_solid_h

#include <softgrain/geometry/rigid_surface.h>
#include <softgrain/mpm/contact/rigid_rays.h>

#include <memory>
#include <utility>

namespace softgrain::mpm
{
/// The surface of an obstacle in space, as rays meet it in the step that is planned for it.
class ObstacleSolid final : public RigidRays<3>
{
public:
  ObstacleSolid(const Obstacle<3> &obstacle, const ObstacleMotion<3> &way);

  const RestSurface<3> &surface() const override { return *shape; }
  /// The places of it that are nearest to those of a body, which are no further than @p reach from it and
  /// face them. They are side by side as those of the body are.
  SampledSurface<3>
  facing(const SampledSurface<3> &body, const dealii::BoundingBox<3> &near, double reach) const override;
  RaySide<3> meet(const Ray<3> &ray, double share, const SurfacePlace<3> &guess) const override;
  dealii::Point<3> placed(const SurfacePlace<3> &place, const double share) const override
  {
    return way.at(share).placed(place.position);
  }
  dealii::Tensor<1, 3> way_of(const SurfacePlace<3> &place) const override
  {
    return way.way_of(place.position);
  }
  double largest_way() const override;
  /// Corners of a box around it, where it is at the start of the step.
  std::pair<dealii::Point<3>, dealii::Point<3>> box() const;

private:
  const std::shared_ptr<const RigidSurface> shape;
  const ObstacleMotion<3> way;
};
} // namespace softgrain::mpm

#endif
