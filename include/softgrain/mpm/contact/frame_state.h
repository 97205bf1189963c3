// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_state_h
#define softgrain_mpm_contact_frame_state_h

#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/frame_search.h>
#include <softgrain/mpm/contact/ray.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief A frame in a step: where its rays meet both surfaces for trial displacements, and what their gaps do
 * to the unknowns.
 *
 * A gap is g = h_body - h_partner, the difference of the heights along a ray. The frame moves across its rays
 * by c, the mean of the displacements over the step of the places that lay under its rays at the start; a
 * wall is no partner in that mean. The force tau that this takes makes the forces on both sides equal and
 * opposite: tau = -sum_k P_k dg_k/dc.
 */
class FrameState
{
public:
  using Vector = dealii::Tensor<1, 2>;
  static constexpr unsigned int none = ContactFrame<2>::none;

  /// Takes weights of the mean from the forces that the rays have, or from the ray with the smallest gap.
  FrameState(const ContactFrame<2> &frame, const FrameScene &scene);

  /// The gap that forces see: dents that the grid misses let both come nearer [m].
  double free_gap(const unsigned int k) const { return rays[k].gap + dent_depth; }
  /// By how much a unit force on a ray closes its gap beside all else [m^2/N]: so little that it shows
  /// nowhere, but where there are more rays than the field of a body has shapes for them, it shares the force
  /// out.
  double ray_softness() const { return softness; }
  double dent_slope() const { return by_force; }
  double total_force() const { return sum_of_forces; }

  /// Meets the surfaces. Rays without force that cannot have come within @p within since they were last met
  /// are not looked at: no place has moved by more than @p path in all since the first call. @param
  /// displacement of all bodies since the grid was laid [m]
  /// @param increment  part of it that belongs to this step [m]
  /// @param wall_way of the wall along its normal over the step [m]
  /// @return false when a ray that carries force is not met
  bool evaluate(const FrameScene &scene,
                const std::vector<Eigen::VectorXd> &displacement,
                const std::vector<Eigen::VectorXd> &increment,
                double wall_way,
                const std::vector<double> &force,
                double path,
                double within);

  struct RayHere
  {
    std::array<RaySide<2>, 2> side; ///< of the partner and the body
    bool met = false;
    bool near = true;     ///< looked at
    double gap = 0;       ///< [m]
    double path = 0;      ///< when it was last looked at
    double by_motion = 0; ///< dg/dc
  };

  unsigned int n_rays() const { return rays.size(); }
  const RayHere &ray(const unsigned int k) const { return rays[k]; }
  /// The body of a side, 0 the partner and 1 the body; none for a wall.
  unsigned int body(const unsigned int side) const { return side == 0 ? frame.partner : frame.body; }
  const ContactFrame<2> &layout() const { return frame; }
  /// c [m].
  double motion() const { return moved; }

  /// Adds dg_k/du of a side to @p nodal, @p factor times.
  void
  add_gradient(unsigned int k, unsigned int side, double factor, Eigen::Ref<Eigen::VectorXd> nodal) const;
  /// Adds dc/du of a side.
  void add_mean(unsigned int side, double factor, Eigen::Ref<Eigen::VectorXd> nodal) const;
  /// Adds sum_k P_k d^2 g_k/du dc of a side. @param force of all rays [N/m]
  void
  add_mixed(unsigned int side, const std::vector<double> &force, Eigen::Ref<Eigen::VectorXd> nodal) const;
  /// sum_k P_k d^2 g_k/dc^2 [N/m^2].
  double twice_by_motion(const std::vector<double> &force) const;
  /// What a unit force of a ray does to the body as a whole; the partner feels the opposite.
  Vector resultant(unsigned int k) const
  {
    return rays[k].side[1].normal + share(1) * rays[k].by_motion * frame.across[0];
  }
  /// tau [N/m].
  double tangential(const std::vector<double> &force) const;

  /// Calls add(i, j, block) for sum of factor d^2 g_k/du^2 of a side.
  template <class F>
  void add_second(const unsigned int k, const unsigned int side, const F &add) const
  {
    rays[k].side[side].second_derivative(add);
  }

  /// The frame as the step leaves it: it has ridden along, and its rays carry @p force.
  ContactFrame<2> after(const std::vector<double> &force) const;

private:
  /// Of the mean motion, that a side has.
  double share(const unsigned int side) const
  {
    if (frame.corner != none)
      return side == frame.corner ? 1. : 0.;
    return frame.partner == none ? 1. : 0.5;
  }
  static double sign(const unsigned int side) { return side == 0 ? -1. : 1.; }

  ContactFrame<2> frame;
  std::vector<RayHere> rays;
  std::array<std::vector<std::pair<unsigned int, double>>, 2> mean; ///< of the places: node, weight
  double moved = 0;
  SubgridCompliance subgrid;
  SubgridCompliance::Dent dent;
  double softness = 0;
  double dent_depth = 0, by_force = 0, sum_of_forces = 0;
};
} // namespace softgrain::mpm

#endif
