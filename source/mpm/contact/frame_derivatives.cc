// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_derivatives.h>

namespace softgrain::mpm
{
template <int dim>
double FrameDerivatives<dim>::twice_by(const std::vector<double> &force,
                                       const std::array<Vector, 2> &v,
                                       const std::array<Vector, 2> &w) const
{
  double sum = 0.;
  for (unsigned int k = 0; k < rays.size(); ++k)
    for (unsigned int side = 0; side < 2; ++side)
      if (force[k] != 0. && rays[k].met && (side == 1 || !state.flat_partner()))
        sum += FrameState<dim>::sign(side) * state.met_at * force[k] *
               (v[side] * (rays[k].side[side].sliding_twice * w[side]));
  return sum;
}

template <int dim>
typename FrameDerivatives<dim>::Across
FrameDerivatives<dim>::tangential(const std::vector<double> &force) const
{
  Across sum;
  for (unsigned int k = 0; k < rays.size(); ++k)
    sum -= force[k] * rays[k].by_motion;
  return sum;
}

template class FrameDerivatives<2>;
template class FrameDerivatives<3>;
} // namespace softgrain::mpm
