// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_obstacle_line_h
#define softgrain_mpm_contact_obstacle_line_h

#include <softgrain/geometry/line_surface.h>
#include <softgrain/mpm/contact/rigid_rays.h>

namespace softgrain::mpm
{
/// The line of an obstacle, as rays meet it in the step that is planned for it.
class ObstacleLine final : public RigidRays<2>
{
public:
  /// @param spacing of samples, at most [m]
  ObstacleLine(const Obstacle<2> &obstacle, double spacing);

  const RestSurface<2> &surface() const override { return line; }
  SampledSurface<2>
  facing(const SampledSurface<2> &body, const dealii::BoundingBox<2> &near, double reach) const override;
  RaySide<2> meet(const Ray<2> &ray, double share, const SurfacePlace<2> &guess) const override;
  dealii::Point<2> placed(const SurfacePlace<2> &place, const double share) const override
  {
    return way.at(share).placed(place.position);
  }
  dealii::Tensor<1, 2> way_of(const SurfacePlace<2> &place) const override
  {
    return way.way_of(place.position);
  }
  double largest_way() const override;
  std::optional<SurfacePlace<2>> place_at(unsigned int piece, double along) const override;

private:
  /// Both sides, where they are at the start of the step.
  SampledSurface<2> sample(double spacing) const;

  const LineSurface line;
  const ObstacleMotion<2> way;
  const SampledSurface<2> samples;
};
} // namespace softgrain::mpm

#endif
