// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ray_rows_h
#define softgrain_mpm_stepping_ray_rows_h

#include <softgrain/mpm/contact/frame_rows.h>
#include <softgrain/mpm/stepping/plane_scene.h>

#include <utility>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The contact rows of an explicit step, one for every ray.
 *
 * Places and normal of a row are those where its ray meets the bodies halfway through the step, if they keep
 * their velocities. Its gap is that at the start of the step, measured along the normal.
 */
class RayRows
{
public:
  /// All are kept by reference. All owners make it together.
  RayRows(const Problem &problem,
          const State &state,
          Workspace &work,
          double dt,
          const std::vector<WallMotion<2>> &motion);

  /// Hands them to the contact problem of the step.
  void find();
  /// The frames as the step leaves them, with the impulses that the contact problem has found.
  std::vector<ContactFrame<2>> frames_after() const;

private:
  void meet(const std::vector<Eigen::VectorXd> &way);
  void add_row(unsigned int f, unsigned int k, std::vector<ContactRow<2>> &rows);

  const State &state;
  Workspace &work;
  const double dt, h;
  PlaneScene plane;
  FrameScene<2> scene;
  double within = 0.; ///< gap up to which a ray has a row [m]
  double path = 0.;   ///< see FrameState::prepare() [m]
  std::vector<FrameState<2>> frames;
  RayForces force;                                        ///< with which the step begins [N/m]
  std::vector<std::pair<unsigned int, unsigned int>> ray; ///< of every row: frame and number
};
} // namespace softgrain::mpm

#endif
