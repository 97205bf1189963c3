// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_memory_h
#define softgrain_mpm_contact_frame_memory_h

#include <softgrain/driving/obstacle.h>
#include <softgrain/geometry/outline_surface.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_frame.h>

#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;
} // namespace softgrain

namespace softgrain::mpm
{
/// Writes the frames of a state as lists below @p name. @param adhere whether rays may pull
void save_frames(StateWriter &out,
                 const std::string &name,
                 const std::vector<ContactFrame<2>> &frames,
                 bool adhere);

/// Reads them back, for bodies that have been read before. @throw InputError for frames that cannot be
void load_frames(const StateReader &in,
                 const std::string &name,
                 const std::vector<Body<2>> &bodies,
                 unsigned int n_walls,
                 const std::vector<Obstacle<2>> &obstacles,
                 std::vector<ContactFrame<2>> &frames);

/// Lays the outlines of bodies whose grid is another one than before, and puts the places of @p frames on
/// them.
void renew_outlines(const std::vector<Body<2>> &bodies,
                    std::vector<OutlineSurface> &outlines,
                    std::vector<ContactFrame<2>> &frames);
} // namespace softgrain::mpm

#endif
