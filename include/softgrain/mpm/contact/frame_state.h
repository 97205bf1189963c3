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

  /// The gap that forces see: dents that the grid misses let both come nearer, and what softness has given to
  /// the force at the start of a step without inertia is taken back [m].
  double free_gap(const unsigned int k) const
  {
    return rays[k].gap + dent_depth - (inertia() ? 0. : softness * frame.rays[k].force);
  }
  /// A unit force on a ray closes its gap by this beside all else [m^2/N]. It is so little that it shows
  /// nowhere, but where a body's field has fewer shapes than there are rays it shares the force out.
  double ray_softness() const { return softness; }
  /// Young's modulus of the softer one, times the edge of a cell in space [N/m^2; N/m].
  double stiffness() const { return young; }
  double dent_slope() const { return by_force; }
  /// Energy in the dent that the grid misses, for these forces of the rays [J/m^(3-dim)].
  double dent_energy(const std::vector<double> &force) const
  {
    return subgrid.energy(dent, std::accumulate(force.begin(), force.end(), 0.));
  }
  double total_force() const { return sum_of_forces; }

  /// The force of a ray as the step begins: no less than adhesion leaves of it [N/m].
  double start_force(const unsigned int k) const
  {
    const double least = -rays[k].held.pull, force = frame.rays[k].force;
    if (rays[k].left)
      return 0.;
    return rays[k].held.pull > 0. && force <= 0. && free_gap(k) > 0. ? least : std::max(force, least);
  }
  /// Finds by how much rays pull in this step: what adhesion does where they were met as the step begins.
  /// @param held the step seeks balance only: pulls go half-way there
  void find_pulls(const FrameScene<dim> &scene, bool held);
  /// The difference of what rays pull to what they would pull where they were last met [N/m].
  double pull_to_come(const FrameScene<dim> &scene) const;
  /// What adhesion does in a step without inertia: parting takes as much less where rays were last met than
  /// at the start [J/m]. Whatever the pull of the step, what comes near and goes again leaves nothing.
  double adhesion_work(const FrameScene<dim> &scene) const;

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

  /// What look() has found, for those who have not looked themselves: numbers of the rays looked at. These
  /// know all of a ray but what nodes do to its places.
  std::size_t n_told() const;
  void tell(double *numbers);
  void take(const double *numbers);

  /// Dents stay what they are for the forces at the start of the step: where bodies resist so much that they
  /// hardly give way, a dent that becomes smaller under a larger force would let a contact go.
  void keep_dent();

  /// Leaves out, for the rest of the step, rays whose surfaces have slid away from under them, as at the end
  /// of a side: their forces become 0, and they pull no more. @return whether there are any
  bool leave_unmet(std::vector<double> &force, std::vector<Across> &rubbing);

  using RayHere = mpm::RayHere<dim>;

  /// Whether a ray is closed: its surfaces part where adhesion alone is left of its force.
  bool closed(const unsigned int k, const double force) const { return force > -rays[k].held.pull; }
  /// The largest friction for a force [N/m].
  double most_friction(const unsigned int k, const double force) const
  {
    return rays[k].rub.bound * (force + rays[k].held.pull);
  }
  /// Whether a ray rubs: a pair with friction, met at the start of the step.
  bool rubs(const unsigned int k) const { return rays[k].rub.bound > 0.; }
  double friction_coefficient() const { return friction; }
  /// Slide that softness lets a force on a ray have that differs from the one at the start of the step [m].
  Across free_slide(const unsigned int k) const
  {
    return rays[k].rub.slide - rays[k].rub.known_slide - softness * frame.rays[k].friction;
  }

  unsigned int n_rays() const { return rays.size(); }
  const RayHere &ray(const unsigned int k) const { return rays[k]; }
  /// The obstacle that is its partner; null: none.
  const ObstacleRays<dim> *obstacle() const { return line; }
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
  /// Whether its motion depends on unknowns: at a corner of an obstacle it does not.
  bool rides() const { return !mean[0].empty() || !mean[1].empty(); }
  /// c [m].
  const Across &motion() const { return moved; }

  /// Calls add(node, vector) for dg_k/du of a side, @p factor times.
  template <class F>
  void for_gradient(const unsigned int k, const unsigned int side, const double factor, const F &add) const
  {
    const RaySide<dim> &here = rays[k].side[side];
    const Vector along = sign(side) * factor * here.normal;
    for (unsigned int i = 0; i < here.function.node.size(); ++i)
      add(here.function.node[i], here.function.value[i] * along);
  }
  /// Adds the derivative of a slide along @p way, in the directions of RayRub::e, by the nodes of a side.
  template <class F>
  void for_slide(const unsigned int k, const unsigned int side, const Across &way, const F &add) const
  {
    Vector along;
    for (unsigned int m = 0; m < dim - 1; ++m)
      along += sign(side) * way[m] * rays[k].rub.e[m];
    const PlaceFunctions<dim> &hold = rays[k].rub.hold[side];
    for (unsigned int i = 0; i < hold.node.size(); ++i)
      add(hold.node[i], hold.value[i] * along);
  }
  /// Adds the derivative of component @p m of c by the nodes of a side.
  template <class F>
  void for_mean(const unsigned int side, const unsigned int m, const double factor, const F &add) const
  {
    if (follows)
    {
      const dealii::Tensor<2, dim - 1> by_difference = invert(change_of_slope());
      for (unsigned int n = 0; n < beside.size(); ++n)
      {
        const RaySide<dim> &here = beside[n].side[side];
        const Vector along =
            (n % 2 == 0 ? 1. : -1.) * sign(side) * factor * by_difference[m][n / 2] * here.normal;
        for (unsigned int i = 0; i < here.function.node.size(); ++i)
          add(here.function.node[i], here.function.value[i] * along);
      }
      return;
    }
    for (const auto &[i, weight] : mean[side])
      add(i, factor * weight * frame.across[m]);
  }
  /// Factor from second derivatives of heights to those of gaps.
  double bend() const { return met_at; }
  /// Adds sum_k P_k d^2 g_k/du dv, where a side moves by @p v. @param force of all rays [N/m]
  template <class F>
  void
  for_mixed(const unsigned int side, const std::vector<double> &force, const Vector &v, const F &add) const
  {
    for (unsigned int k = 0; k < rays.size(); ++k)
    {
      if (force[k] == 0. || !rays[k].met)
        continue;
      const RaySide<dim> &here = rays[k].side[side];
      const Vector twice = here.sliding_twice * v;
      for (unsigned int i = 0; i < here.function.node.size(); ++i)
      {
        double along = (here.function.slope[i] * here.place.tangent[0]) * (here.way[0] * v);
        if constexpr (dim == 3)
          along += (here.function.slope[i] * here.place.tangent[1]) * (here.way[1] * v);
        add(here.function.node[i],
            sign(side) * bend() * force[k] * (here.function.value[i] * twice + along * here.normal));
      }
    }
  }
  /// The motion of a side that does what the frame's own does in its component @p m: a ray that moves by c
  /// meets a body that has moved by -c.
  Vector as_motion(const unsigned int m) const { return -frame.across[m]; }
  /// sum_k P_k d^2 g_k/dv dw, where the sides move by @p v and by @p w [N/m^2].
  double twice_by(const std::vector<double> &force,
                  const std::array<Vector, 2> &v,
                  const std::array<Vector, 2> &w) const;
  /// sum_k P_k d^2 g_k/dc_m dc_n [N/m^2].
  double twice_by_motion(const std::vector<double> &force, const unsigned int m, const unsigned int n) const
  {
    return twice_by(force, {{as_motion(m), as_motion(m)}}, {{as_motion(n), as_motion(n)}});
  }
  /// What a unit force of a ray does to the body as a whole; the partner feels the opposite.
  Vector resultant(unsigned int k) const;
  /// tau [N/m].
  Across tangential(const std::vector<double> &force) const;

  /// What it does to the gap of a ray, at a place of the frame that stays, that its sides move, and to its
  /// slide.
  double gap_by(const unsigned int k, const std::array<Vector, 2> &moves) const
  {
    const Vector partner = flat_partner() ? frame.direction : rays[k].side[0].normal;
    return rays[k].side[1].normal * moves[1] - partner * moves[0];
  }
  Across slide_by(const unsigned int k, const std::array<Vector, 2> &moves) const
  {
    return along_slides(k, moves[1] - moves[0]);
  }
  /// Components of a vector along RayRub::e.
  Across along_slides(unsigned int k, const Vector &way) const;
  /// The vector that stands at @p way in the directions of RayRub::e.
  Vector in_space(unsigned int k, const Across &way) const;
  /// What it does to the mean motion across the rays.
  Across motion_by(const std::array<Vector, 2> &moves) const;

  /// Adds those of its rays, after a step without inertia.
  void
  add_kinks(const std::vector<double> &force, const std::vector<Across> &rubbing, ContactKinks &kinks) const;

  /// The frame as the step leaves it: it has ridden along, and its rays carry @p force and @p rubbing.
  ContactFrame<dim> after(const FrameScene<dim> &scene,
                          const std::vector<double> &force,
                          const std::vector<Across> &rubbing) const;

private:
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
  /// The length of outline that a ray stands for, to one side of it [m].
  struct HalfLength
  {
    double length = 0; ///< across the rays
    double gap = 0;    ///< at its end
  };
  std::array<HalfLength, 2> half_lengths(const FrameScene<dim> &scene, unsigned int k) const;
  double pull_now(const FrameScene<dim> &scene, unsigned int k) const;
  double parts_for_now(const FrameScene<dim> &scene, unsigned int k) const;
  bool has_neighbour(unsigned int k, int direction) const;
  double way_to_edge(const FrameScene<dim> &scene, unsigned int k, double direction) const;
  double memory_after(const FrameScene<dim> &scene, unsigned int k, double force, double rubbing) const;
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
  template <class Part>
  void for_told(RayHere &ray, const Part &part) const;

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
  const ObstacleRays<dim> *line = nullptr;
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
  /// Rays half a spacing before and behind the contact, in every direction across the rays.
  std::array<RayHere, 2 * (dim - 1)> beside;
  Across kept;               ///< differences of their gaps [m]
  double bend_at_start = 0.; ///< of the gap across the rays, in space the product of both [m^(1-dim)]
  double widest = 0.;        ///< force beyond which the contact is not narrow [N/m^(3-dim)]
};
} // namespace softgrain::mpm

#include <softgrain/mpm/contact/frame_state.templates.h>

#endif
