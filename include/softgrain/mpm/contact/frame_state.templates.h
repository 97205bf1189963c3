// SPDX-License-Identifier: LGPL-2.1-or-later
// Short functions of a frame's state that are called for every ray, and are better put where they are called.
#ifndef softgrain_mpm_contact_frame_state_templates_h
#define softgrain_mpm_contact_frame_state_templates_h

namespace softgrain::mpm
{
template <int dim>
typename FrameState<dim>::Vector FrameState<dim>::by_whole_side(const unsigned int side,
                                                                const unsigned int m) const
{
  if (!follows)
    return share(side) * frame.across[m];
  if (side == 0 && flat_partner())
    return Vector();
  const dealii::Tensor<2, dim - 1> by_difference = invert(change_of_slope());
  Vector sum;
  for (unsigned int n = 0; n < dim - 1; ++n)
    sum += sign(side) * by_difference[m][n] *
           (beside[2 * n].side[side].normal - beside[2 * n + 1].side[side].normal);
  return sum;
}

template <int dim>
typename FrameState<dim>::Across FrameState<dim>::difference_beside() const
{
  Across difference;
  for (unsigned int m = 0; m < dim - 1; ++m)
    difference[m] = beside[2 * m + 1].gap - beside[2 * m].gap;
  return difference;
}
} // namespace softgrain::mpm

#endif
