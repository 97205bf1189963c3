// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_search_h
#define softgrain_mpm_contact_frame_search_h

#include <softgrain/analysis/partner_numbers.h>
#include <softgrain/driving/adhesion.h>
#include <softgrain/driving/cell_motion.h>
#include <softgrain/geometry/outline_surface.h>
#include <softgrain/geometry/solid_surface.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/hertz_compliance.h>
#include <softgrain/mpm/contact/ray.h>
#include <softgrain/mpm/contact/rigid_rays.h>
#include <softgrain/mpm/contact/subgrid_compliance.h>
#include <softgrain/scene/contact_pairs.h>

#include <type_traits>
#include <vector>

namespace softgrain::mpm
{
/// What rays meet of a body.
template <int dim>
using BodySurface = std::conditional_t<dim == 2, OutlineSurface, SolidSurface>;

/// The law of dents that a grid misses.
template <int dim>
using SubgridLaw = std::conditional_t<dim == 2, SubgridCompliance, HertzCompliance>;

/// The ways of bodies over a step that a search for frames knows of.
template <int dim>
struct FrameWays
{
  /// Beside what their nodes do, since they are driven or a cell takes them along; empty: there is none [m].
  std::vector<dealii::Tensor<1, dim>> carried = {};
  /// How far the outline of every body would go at its present velocity; empty: without inertia [m].
  std::vector<double> own = {};

  double own_of(const unsigned int body) const { return own.empty() ? 0. : own[body]; }
};

/// When rays meet surfaces in a step.
struct RayInstants
{
  /// Share of the step after which they do. 1: its end, where a step without inertia is in balance; 1/2: with
  /// inertia, so that forces between rest places do no work.
  double met_at = 1.;
  double theta = 1.; ///< of TimeScheme

  bool inertia() const { return met_at < 1.; }
};

/// What a search for frames looks at.
template <int dim>
struct FrameScene
{
  const std::vector<Body<dim>> &bodies;
  const std::vector<BodySurface<dim>> &outlines; ///< of the bodies, in the configuration of their grids
  const std::vector<WallMotion<dim>> &walls;
  double cell_size;                      ///< [m]
  SubgridLaw<dim> subgrid;               ///< what the grid misses of dents
  double reach;                          ///< gap up to which places of bodies at rest are looked at [m]
  const ContactPairs *pairs = nullptr;   ///< what bodies and walls do to each other; null: no friction
  const CellMotion<dim> *cell = nullptr; ///< that repeats; null: nothing does
  double dt = 0.;                        ///< [s]
  FrameWays<dim> ways = {};
  RayInstants instants = {};
  const AllRigidRays<dim> *lines = nullptr; ///< of the obstacles; null: there are none
  const Adhesion *adhesion = nullptr;       ///< null: nothing adheres
  const BodyShare *looking = nullptr; ///< every owner looks for its bodies, and learns of all; null: for all

  /// What rays meet of the obstacle that a frame belongs to; null: it has another partner.
  const RigidRays<dim> *line_of(const ContactFrame<dim> &frame) const
  {
    const unsigned int o = lines == nullptr ? PartnerNumbers::none : obstacle_of(*this, frame);
    return o == PartnerNumbers::none ? nullptr : (*lines)[o].get();
  }
};

/// Number of the obstacle that a frame belongs to, among obstacles; none: another partner.
template <int dim>
unsigned int obstacle_of(const FrameScene<dim> &scene, const ContactFrame<dim> &frame)
{
  return frame.partner == PartnerNumbers::none ? PartnerNumbers(scene.walls.size()).obstacle(frame.wall)
                                               : PartnerNumbers::none;
}

/// Gap up to which places of a pair are looked at [m].
template <int dim>
double reach_of(const FrameScene<dim> &scene, const ContactFrame<dim> &frame)
{
  return scene.reach + scene.ways.own_of(frame.body) +
         (frame.partner == ContactFrame<dim>::none ? 0. : scene.ways.own_of(frame.partner));
}

/// The surface of a side of a frame, 0 the partner, which is no wall, and 1 the body.
template <int dim>
const RestSurface<dim> &
surface_of(const FrameScene<dim> &scene, const ContactFrame<dim> &frame, const unsigned int side)
{
  if (side == 0 && frame.partner == ContactFrame<dim>::none)
    return scene.line_of(frame)->surface();
  return scene.outlines[side == 0 ? frame.partner : frame.body];
}

/// Gaps that differ by less are the same [m].
template <int dim>
double same_gap(const FrameScene<dim> &scene)
{
  return 1e-6 * scene.cell_size;
}

/// How far sides go on straight beyond their ends for the corners of others [m]: where two corners pass by
/// each other at rest, each meets the side of the other while they do. Bodies that move pass in any case.
template <int dim>
double past_ends(const FrameScene<dim> &scene)
{
  return scene.instants.inertia() ? 0. : 0.02 * scene.cell_size;
}

/// The way of a wall over the step; an obstacle and a body, whose number is none, have no such way [m].
template <int dim>
dealii::Tensor<1, dim> way_of_wall(const FrameScene<dim> &scene, const unsigned int w)
{
  if (!PartnerNumbers(scene.walls.size()).is_wall(w))
    return dealii::Tensor<1, dim>();
  const WallMotion<dim> &wall = scene.walls[w];
  return scene.dt * (wall.velocity * wall.normal + wall.slide * wall.tangent());
}

/// The vector from the partner of a frame to the image of it that the body meets, as the step starts [m].
template <int dim>
dealii::Tensor<1, dim> apart_of(const FrameScene<dim> &scene, const ContactFrame<dim> &frame);

/// A ray of a frame, @p offset [m] beside its origin, in the places of a body that stands @p away [m] from
/// where the frame has it.
template <int dim>
Ray<dim> ray_of(const ContactFrame<dim> &frame,
                const dealii::Tensor<1, dim - 1> &offset,
                const dealii::Tensor<1, dim> &away = dealii::Tensor<1, dim>());

/**
 * @brief The frames of all that is near each other where the bodies are now.
 *
 * A stretch that is already covered by one of the frames @p before, whose direction it has kept within 11
 * degrees, keeps that frame and the forces of its rays.
 */
template <int dim>
std::vector<ContactFrame<dim>> find_frames(const FrameScene<dim> &scene,
                                           std::vector<ContactFrame<dim>> before);
} // namespace softgrain::mpm

#endif
