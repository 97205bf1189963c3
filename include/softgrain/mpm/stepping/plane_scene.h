// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_plane_scene_h
#define softgrain_mpm_stepping_plane_scene_h

#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/stepping/step.h>

#include <optional>
#include <vector>

namespace softgrain::mpm
{
/// What rays of a two-dimensional step meet beside free bodies and plane walls: obstacles, bodies that are
/// driven, and images of bodies in a cell that repeats.
class PlaneScene
{
public:
  /// All are kept by reference. All owners make it together.
  PlaneScene(const Problem &problem,
             const State &state,
             const Workspace &work,
             double dt,
             const std::vector<WallMotion<2>> &motion);
  PlaneScene(const PlaneScene &) = delete;

  /// Adds all this to @p scene, which refers to it from now on.
  void complete(FrameScene<2> &scene) const;
  /// Tells @p scene where walls under loads are after they have moved.
  void renew(FrameScene<2> &scene);
  /// Largest way over the step of an obstacle or of a body that is driven [m].
  double largest_way() const;

private:
  using Vector = dealii::Tensor<1, 2>;
  std::vector<Vector> ways_of_bodies() const;
  std::vector<double> own_ways() const;

  const Problem &problem;
  const State &state;
  const Workspace &work;
  const double dt;
  const std::vector<WallMotion<2>> &motion;
  std::optional<CellMotion<2>> cell;
  const AllRigidRays<2> lines;
};
} // namespace softgrain::mpm

#endif
