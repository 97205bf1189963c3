// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_history_columns_h
#define softgrain_app_history_columns_h

#include <softgrain/analysis/contact_loads.h>
#include <softgrain/scene/scene.h>

namespace softgrain
{
/**
 * @brief Looks whether the columns that walls and obstacles have in history.csv can be told apart.
 *
 * A column is called after its wall or obstacle, "NAME_work_J_per_m" for example. Nothing may be called as
 * what does work in every scene, "growth" for example, whether this scene has that or not; nor may a wall
 * and an obstacle have one name.
 *
 * @throw InputErrors with a line for each name
 */
void check_history_columns(const Scene<2> &scene);

/**
 * @brief The columns of loads that are asked for.
 * @param scene with the bodies of its packing
 * @throw InputErrors with a line for each that cannot be
 */
ContactLoads contact_loads(const std::vector<LoadWish> &wishes, const Scene<2> &scene);
} // namespace softgrain

#endif
