// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_rigid_rays_h
#define softgrain_mpm_contact_rigid_rays_h

#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/contact/near_stretches.h>
#include <softgrain/mpm/contact/ray.h>

#include <deal.II/base/bounding_box.h>

#include <memory>
#include <optional>
#include <vector>

namespace softgrain::mpm
{
/// What rays meet of something rigid that is no plane, in the step that is planned for it. Places are those
/// of its surface as drawn.
template <int dim>
class RigidRays
{
public:
  explicit RigidRays(const double friction) : friction(friction) {}
  virtual ~RigidRays() = default;
  RigidRays(const RigidRays &) = delete;

  virtual const RestSurface<dim> &surface() const = 0; ///< as drawn

  /// Samples of what a body may meet of it, where it is at the start of the step.
  /// @param near  box in which the body, with what it may reach, is
  /// @param reach gap up to which places are looked at [m]
  virtual SampledSurface<dim>
  facing(const SampledSurface<dim> &body, const dealii::BoundingBox<dim> &near, double reach) const = 0;

  /// Where a ray meets it @p share of the step after its start.
  virtual RaySide<dim> meet(const Ray<dim> &ray, double share, const SurfacePlace<dim> &guess) const = 0;

  /// Where a place is @p share of the step after its start.
  virtual dealii::Point<dim> placed(const SurfacePlace<dim> &place, double share) const = 0;
  /// Way of a place over the step [m].
  virtual dealii::Tensor<1, dim> way_of(const SurfacePlace<dim> &place) const = 0;
  virtual double largest_way() const = 0; ///< of all its places [m]

  /// A place of a surface of pieces, by its piece and the distance from where that begins [m]; none: there is
  /// no such piece.
  virtual std::optional<SurfacePlace<dim>> place_at(unsigned int /*piece*/, double /*along*/) const
  {
    return std::nullopt;
  }

  const double friction;
};

/// One for each rigid thing that is no plane, in their order.
template <int dim>
using AllRigidRays = std::vector<std::unique_ptr<const RigidRays<dim>>>;

/// What rays meet of obstacles in the step that is planned for them. @param spacing of samples, at most [m]
AllRigidRays<2> rays_of(const std::vector<Obstacle<2>> &obstacles, double spacing);
/// What they meet in space. @param ways of the obstacles in the step
AllRigidRays<3> rays_of(const std::vector<Obstacle<3>> &obstacles,
                        const std::vector<ObstacleMotion<3>> &ways);
} // namespace softgrain::mpm

#endif
