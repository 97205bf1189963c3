// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_space_ray_step_h
#define softgrain_mpm_stepping_space_ray_step_h

#include <softgrain/mpm/stepping/ray_newton.h>
#include <softgrain/mpm/stepping/space_step.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/// A step in space, at rest or with inertia: how it finds ways and forces, and what becomes of contacts.
class SpaceRayStep : private RayNewton<3>
{
public:
  SpaceRayStep(SpaceState &state,
               const SpaceScene &space,
               const std::vector<WallMotion<3>> &motion,
               const StepPlan &plan,
               BodyEquations<3> &equations);

  using RayNewton<3>::careful;
  using RayNewton<3>::most_resistance;
  using RayNewton<3>::outcome;

  std::string find() { return converge(); }

protected:
  using RayNewton<3>::contact_forces;
  using RayNewton<3>::force;
  using RayNewton<3>::frames;
  using RayNewton<3>::plan;
  using RayNewton<3>::rubbing;
  using RayNewton<3>::scene;
  using RayNewton<3>::trial;
  using RayNewton<3>::Vectors;
  using RayNewton<3>::way;
  using RayNewton<3>::world;

  /// Writes contacts, frames and forces on walls into the state, and moves the bodies.
  void accept_ways(SpaceState &state);

private:
  std::string partner_of(const ContactFrame<3> &frame) const override;
  void add_contacts(unsigned int f, SpaceState &state) const;

  const std::vector<std::string> &wall_names;
};
} // namespace softgrain::mpm

#endif
