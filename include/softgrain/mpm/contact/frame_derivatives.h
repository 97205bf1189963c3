// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_derivatives_h
#define softgrain_mpm_contact_frame_derivatives_h

#include <softgrain/mpm/contact/frame_state.h>

#include <array>
#include <vector>

namespace softgrain::mpm
{
/// What nodes, and motions of whole sides, do to gaps, slides and the mean motion of a frame; see FrameState
/// for the names. It looks at the state of the frame, and lives no longer.
template <int dim>
class FrameDerivatives
{
public:
  using Vector = dealii::Tensor<1, dim>;
  using Across = dealii::Tensor<1, dim - 1>; ///< a component for each direction across the rays

  explicit FrameDerivatives(const FrameState<dim> &state) : state(state), frame(state.frame), rays(state.rays)
  {
  }

  /// Whether the motion of the frame depends on unknowns: at a corner of an obstacle it does not.
  bool rides() const { return !state.mean[0].empty() || !state.mean[1].empty(); }
  /// c [m].
  const Across &motion() const { return state.moved; }

  /// Calls add(node, vector) for dg_k/du of a side, @p factor times.
  template <class F>
  void for_gradient(const unsigned int k, const unsigned int side, const double factor, const F &add) const
  {
    const RaySide<dim> &here = rays[k].side[side];
    const Vector along = FrameState<dim>::sign(side) * factor * here.normal;
    for (unsigned int i = 0; i < here.function.node.size(); ++i)
      add(here.function.node[i], here.function.value[i] * along);
  }
  /// Adds the derivative of a slide along @p way, in the directions of RayRub::e, by the nodes of a side.
  template <class F>
  void for_slide(const unsigned int k, const unsigned int side, const Across &way, const F &add) const
  {
    Vector along;
    for (unsigned int m = 0; m < dim - 1; ++m)
      along += FrameState<dim>::sign(side) * way[m] * rays[k].rub.e[m];
    const PlaceFunctions<dim> &hold = rays[k].rub.hold[side];
    for (unsigned int i = 0; i < hold.node.size(); ++i)
      add(hold.node[i], hold.value[i] * along);
  }
  /// Adds the derivative of component @p m of c by the nodes of a side.
  template <class F>
  void for_mean(const unsigned int side, const unsigned int m, const double factor, const F &add) const
  {
    if (state.follows)
    {
      const dealii::Tensor<2, dim - 1> by_difference = invert(state.change_of_slope());
      for (unsigned int n = 0; n < state.beside.size(); ++n)
      {
        const RaySide<dim> &here = state.beside[n].side[side];
        const Vector along = (n % 2 == 0 ? 1. : -1.) * FrameState<dim>::sign(side) * factor *
                             by_difference[m][n / 2] * here.normal;
        for (unsigned int i = 0; i < here.function.node.size(); ++i)
          add(here.function.node[i], here.function.value[i] * along);
      }
      return;
    }
    for (const auto &[i, weight] : state.mean[side])
      add(i, factor * weight * frame.across[m]);
  }
  /// Factor from second derivatives of heights to those of gaps.
  double bend() const { return state.met_at; }
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
        add(here.function.node[i], FrameState<dim>::sign(side) * bend() * force[k] *
                                       (here.function.value[i] * twice + along * here.normal));
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
  Vector resultant(const unsigned int k) const
  {
    Vector sum = rays[k].side[1].normal;
    for (unsigned int m = 0; m < dim - 1; ++m)
      sum += rays[k].by_motion[m] * state.by_whole_side(1, m);
    return sum;
  }
  /// tau [N/m].
  Across tangential(const std::vector<double> &force) const;

  /// What it does to the gap of a ray, at a place of the frame that stays, that its sides move, and to its
  /// slide.
  double gap_by(const unsigned int k, const std::array<Vector, 2> &moves) const
  {
    const Vector partner = state.flat_partner() ? frame.direction : rays[k].side[0].normal;
    return rays[k].side[1].normal * moves[1] - partner * moves[0];
  }
  Across slide_by(const unsigned int k, const std::array<Vector, 2> &moves) const
  {
    return rays[k].rub.along(moves[1] - moves[0]);
  }
  /// What that does to the mean motion across the rays.
  Across motion_by(const std::array<Vector, 2> &moves) const
  {
    Across result;
    for (unsigned int m = 0; m < dim - 1; ++m)
      result[m] = state.by_whole_side(0, m) * moves[0] + state.by_whole_side(1, m) * moves[1];
    return result;
  }

private:
  const FrameState<dim> &state;
  const ContactFrame<dim> &frame;
  const std::vector<RayHere<dim>> &rays;
};
} // namespace softgrain::mpm

#endif
