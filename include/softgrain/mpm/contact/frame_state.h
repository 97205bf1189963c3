// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_state_h
#define softgrain_mpm_contact_frame_state_h

#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/contact_kinks.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/ray_here.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace softgrain::mpm
{
template <int dim>
class FrameDerivatives;
template <int dim>
class FrameConditions;
template <int dim>
class FrameAdhesion;
template <int dim>
class ToldFrame;

/**
 * @brief A frame in a step: where its rays meet both surfaces for trial displacements, and what their gaps do
 * to the unknowns.
 *
 * A gap is g = h_body - h_partner, the difference of the heights along a ray. With inertia rays meet surfaces
 * where they are halfway, and the gap at the end is what it was and Δg = ∇g(halfway)·Δu, which is that of the
 * end but for terms of third order: so forces on a gap that stays closed do no work. Newton's matrix holds
 * ∇g for its derivative; what that lacks, half the second derivative times Δu, costs up to half an iteration
 * a step. The frame moves across its rays by c, the mean of the
 * displacements over the step of the places that lay under its rays at the start; a wall is no partner in
 * that mean. With inertia a contact that is narrower than its rays are apart is followed:
 * c is such that the gaps half a spacing before and behind it differ, halfway, by what they did at the start,
 * in every direction across the rays, so on round surfaces rays stay as far from the least gap as they were.
 * The force tau that this takes makes the forces on both sides equal and opposite: tau = -sum_k P_k dg_k/dc.
 *
 * Friction holds together the two places of the material that lay under a ray at the start of the step. Its
 * slide is what they have moved past each other since then, along the unit vectors e at right angles to what
 * the ray's force does: linear in the unknowns, without a second derivative, and nothing need be remembered
 * from step to step but the force. Under a ray that follows its contact they are the places that it meets
 * halfway, so rolling is no slide.
 */
template <int dim>
class FrameState
{
public:
  using Vector = dealii::Tensor<1, dim>;
  using Across = dealii::Tensor<1, dim - 1>; ///< a component for each direction across the rays
  static constexpr unsigned int none = ContactFrame<dim>::none;

  /// Takes weights of the mean from the forces that the rays have, or from the ray with the smallest gap.
  FrameState(const ContactFrame<dim> &frame, const FrameScene<dim> &scene);

  /// Learns where its sides have moved, as all owners do, and finds the rays that look() is to look along:
  /// not those without force that cannot have come within @p within since they were last met. No place has
  /// moved by more than @p path in all since the first call.
  /// @param increment displacement of all bodies in this step, none in the first call [m]
  void prepare(const FrameScene<dim> &scene,
               const std::vector<Eigen::VectorXd> &increment,
               const std::vector<double> &force,
               double path,
               double within);
  /// Meets the surfaces. With inertia the first call meets them as the step begins.
  /// @param displacement of all bodies since the grid was laid [m]
  /// @param increment part of it that belongs to this step [m]
  /// @param wall_way of the wall over the step [m]
  void look(const FrameScene<dim> &scene,
            const std::vector<Eigen::VectorXd> &displacement,
            const std::vector<Eigen::VectorXd> &increment,
            const Vector &wall_way,
            const std::vector<double> &force);
  /// Whether all rays that carry force are met.
  bool meets(const std::vector<double> &force) const;

  /// Gives dents, for the rest of the step, the depth that the forces at its start give them. This is for
  /// bodies that hardly give way: there a dent that becomes smaller under a larger force would open the
  /// contact.
  void keep_dent();
  /// Notes whether a ray's slide is left out of what is measured, since its friction was kept and not sought.
  void keep_friction(const unsigned int k, const bool keeps) { rays[k].rub.keeps = keeps; }

  /// Leaves out, for the rest of the step, rays whose surfaces have slid away from under them, as at the end
  /// of a side: their forces become 0, and they pull no more. @return whether there are any
  bool leave_unmet(std::vector<double> &force, std::vector<Across> &rubbing);

  using RayHere = mpm::RayHere<dim>;

  /// What its rays do to the unknowns of a step.
  FrameDerivatives<dim> derivatives() const { return FrameDerivatives<dim>(*this); }
  /// What is asked of the forces of its rays.
  FrameConditions<dim> conditions() const { return FrameConditions<dim>(*this); }

  unsigned int n_rays() const { return rays.size(); }
  const RayHere &ray(const unsigned int k) const { return rays[k]; }
  /// The body of a side, 0 the partner and 1 the body; none for a wall.
  unsigned int body(const unsigned int side) const { return side == 0 ? frame.partner : frame.body; }
  /// The body of a side if its nodes are unknown; none for a body that is driven.
  unsigned int unknown(const unsigned int side) const
  {
    return side == 0 && partner_is_driven ? none : body(side);
  }
  /// The vector from the partner to the image of it that the body meets, at the start of the step [m].
  const Vector &image_shift() const { return apart; }
  const ContactFrame<dim> &layout() const { return frame; }
  /// The frame as the step leaves it: it has ridden along, and its rays carry @p force and @p rubbing.
  ContactFrame<dim> after(const FrameScene<dim> &scene,
                          const std::vector<double> &force,
                          const std::vector<Across> &rubbing) const;

private:
  friend class FrameDerivatives<dim>;
  friend class FrameConditions<dim>;
  friend class FrameAdhesion<dim>;
  friend class ToldFrame<dim>;

  bool inertia() const { return met_at < 1.; }
  /// The share of the mean motion that a side has.
  double share(const unsigned int side) const
  {
    if (frame.corner != none)
      return side == frame.corner ? 1. : 0.;
    return unknown(0) == none ? side : 0.5;
  }
  /// What a motion of a whole side does to component @p m of c.
  Vector by_whole_side(unsigned int side, unsigned int m) const;
  /// The change of the gap's slope across a contact that is followed, from half a spacing before it to half a
  /// spacing behind it: for every direction across the rays what the frame's motion does to the difference of
  /// these two gaps.
  dealii::Tensor<2, dim - 1> change_of_slope() const
  {
    dealii::Tensor<2, dim - 1> change;
    for (unsigned int m = 0; m < dim - 1; ++m)
      change[m] = beside[2 * m + 1].by_motion - beside[2 * m].by_motion;
    return change;
  }
  /// Difference of these gaps, in every direction [m].
  Across difference_beside() const;
  /// Whether the partner is a wall.
  bool flat_partner() const { return frame.partner == none && line == nullptr; }
  /// Way over the step of a place of a partner that is a wall or an obstacle; of a body 0 [m].
  Vector way_of_partner(const Vector &wall_way, const SurfacePlace<dim> &place) const
  {
    if (line != nullptr)
      return line->way_of(place);
    return frame.partner == none ? wall_way : Vector();
  }
  void note_gap_at_start(const Vector &wall_way, unsigned int k);
  static double sign(const unsigned int side) { return side == 0 ? -1. : 1.; }
  /// The vector by which a side stands away from where its nodes say.
  Vector away(const unsigned int side) const { return at * carried[side] + (side == 0 ? apart : Vector()); }
  bool meet_side(const FrameScene<dim> &scene,
                 const std::vector<Eigen::VectorXd> &displacement,
                 double wall_height,
                 unsigned int side,
                 const Across &offset,
                 const SurfacePlace<dim> &guess,
                 RayHere &here) const;
  bool meet_ray(const FrameScene<dim> &scene,
                const std::vector<Eigen::VectorXd> &displacement,
                double wall_height,
                unsigned int k);
  void look_closer(const FrameScene<dim> &scene,
                   const std::vector<Eigen::VectorXd> &increment,
                   const Vector &wall_way,
                   unsigned int k,
                   double force);
  void look_for_slide(const FrameScene<dim> &scene,
                      const std::vector<Eigen::VectorXd> &increment,
                      const Vector &wall_way,
                      unsigned int k);
  void begin_to_rub(const FrameScene<dim> &scene, const Vector &wall_way, unsigned int k);
  void hold_at(const FrameScene<dim> &scene,
               const std::array<SurfacePlace<dim>, 2> &place,
               const Vector &wall_way,
               unsigned int k);
  RaySide<dim> meet_surface(const FrameScene<dim> &scene,
                            const std::vector<Eigen::VectorXd> &displacement,
                            unsigned int side,
                            const Ray<dim> &ray,
                            const SurfacePlace<dim> &guess) const;
  void
  meet_corner(const FrameScene<dim> &scene, const std::vector<Eigen::VectorXd> &displacement, unsigned int k);
  double share_that_opens(const FrameScene<dim> &scene) const;
  void draw_on(unsigned int k);
  Across mean_motion(const std::vector<Eigen::VectorXd> &increment) const;
  bool meet_beside(const FrameScene<dim> &scene,
                   const std::vector<Eigen::VectorXd> &displacement,
                   double wall_height);
  void choose_followed(const FrameScene<dim> &scene,
                       const std::vector<Eigen::VectorXd> &displacement,
                       double wall_height);
  void follow(const FrameScene<dim> &scene,
              const std::vector<Eigen::VectorXd> &displacement,
              const std::vector<Eigen::VectorXd> &increment,
              double wall_height);
  /// What the whole step adds to a gap as it opens halfway [m].
  double added(unsigned int k, const std::vector<Eigen::VectorXd> &increment, const Vector &wall_way) const;
  Vector parted(unsigned int k, const std::vector<Eigen::VectorXd> &increment, const Vector &wall_way) const;

  ContactFrame<dim> frame;
  std::vector<RayHere> rays;
  std::array<std::vector<std::pair<unsigned int, double>>, 2> mean; ///< of the places: node, weight
  Across moved;
  Vector apart;
  std::array<Vector, 2> carried;
  void carry(const FrameScene<dim> &scene);
  void find_pair(const FrameScene<dim> &scene);
  void weigh_rays(const FrameScene<dim> &scene);
  double gap_at_places(const FrameScene<dim> &scene, unsigned int k) const;
  void find_mean(const FrameScene<dim> &scene);
  bool meets_bent_obstacle(const FrameScene<dim> &scene) const;
  bool partner_is_driven = false;
  const RigidRays<dim> *line = nullptr;
  double met_at = 1., theta = 1.;
  bool begun = false, begins = false; ///< rays were looked at in this step, and are for the first time
  double looks_within = 0.;           ///< gap up to which more is asked of rays than their gaps [m]
  double at = 1.;                     ///< share of the step after which rays were last met
  double dent_at_start = 0., opens = 1.;
  SubgridLaw<dim> subgrid;
  typename SubgridLaw<dim>::Dent dent;
  double young = 0, softness = 0, friction = 0, strength = 0;
  double dent_depth = 0, by_force = 0, sum_of_forces = 0;
  bool keeps_dent = false;

  bool follows = false;       ///< its contact, with inertia
  std::vector<double> weight; ///< of its rays: their shares in the force at the start
  /// Rays half a spacing before and behind the contact, in every direction across the rays; without inertia
  /// none.
  std::vector<RayHere> beside;
  Across kept;               ///< differences of their gaps [m]
  double bend_at_start = 0.; ///< of the gap across the rays, in space the product of both [m^(1-dim)]
  double widest = 0.;        ///< force beyond which the contact is not narrow [N/m^(3-dim)]
};
} // namespace softgrain::mpm

#include <softgrain/mpm/contact/frame_conditions.h>
#include <softgrain/mpm/contact/frame_derivatives.h>
#include <softgrain/mpm/contact/frame_state.templates.h>

#endif
