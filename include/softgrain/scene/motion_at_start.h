// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_motion_at_start_h
#define softgrain_scene_motion_at_start_h

#include <softgrain/scene/scene.h>

namespace softgrain
{
/// Whether a body starts with a velocity other than 0, but for a rotation.
template <int dim>
bool starts_in_motion(const BodyDescription<dim> &body);

/// Whether bodies are moved by more than walls: by loads, by what they have at the start, by obstacles that
/// move. Bodies that move rigidly count as walls.
template <int dim>
bool moved_by_more_than_walls(const Scene<dim> &scene);
} // namespace softgrain

#endif
