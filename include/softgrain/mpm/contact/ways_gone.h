// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_ways_gone_h
#define softgrain_mpm_contact_ways_gone_h

#include <softgrain/mpm/contact/contact_frame.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief How far places of bodies may have gone in a step, all trials summed: no ray whose surfaces have not
 * come as near as that need be followed again. Bodies far from a rearrangement hardly move, so each has its
 * own way [m].
 */
class WaysGone
{
public:
  /// @param first with which all frames begin, larger than 0
  WaysGone(const unsigned int n_bodies, const double first) : of_body(n_bodies), common(first) {}

  /// The largest sum for two places that a frame has to do with.
  template <int dim>
  double between(const ContactFrame<dim> &frame) const
  {
    return common + of_body[frame.body] +
           (frame.partner == ContactFrame<dim>::none ? 0. : of_body[frame.partner]);
  }
  /// All places have gone further, as walls under loads make them do.
  void add(const double way) { common += way; }

  std::vector<double> of_body;

private:
  double common;
};
} // namespace softgrain::mpm

#endif
