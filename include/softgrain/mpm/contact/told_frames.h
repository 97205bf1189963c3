// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_told_frames_h
#define softgrain_mpm_contact_told_frames_h

#include <softgrain/mpm/contact/contact_frame.h>

#include <vector>

namespace softgrain::mpm
{
/// Adds the frames of one pair to what is told to others.
template <int dim>
void tell_frames(const std::vector<ContactFrame<dim>> &frames, std::vector<double> &numbers);

/// Frames of one pair as tell_frames() has told them.
/// @param named body, partner, wall and image that they have
/// @param at    where they begin; becomes the place behind them
template <int dim>
std::vector<ContactFrame<dim>> take_frames(const ContactFrame<dim> &named, const double *&at);
} // namespace softgrain::mpm

#endif
