// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_scene_checks_h
#define softgrain_scene_scene_checks_h

#include <softgrain/scene/scene.h>

namespace softgrain
{
/**
 * @brief Looks at a whole scene before anything is computed, and again when its packing has been made.
 *
 * Bodies must have an area, lie on the inner side of every wall and not overlap (touching within 1e-9 of
 * their size is fine); opposing walls must leave room; formulas must parse and be finite at the start.
 *
 * @throw InputError naming what is wrong and by how much.
 */
void check_scene(const Scene<2> &scene);
} // namespace softgrain

#endif
