// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_refinement_h
#define softgrain_mpm_body_refinement_h

#include <softgrain/mpm/field/cell_levels.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/scene.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/// Sizes of the cells of every body of a scene; null: as the lattice has them.
using LevelsOfScene = std::vector<std::shared_ptr<const CellLevels<2>>>;

/// Whether a scene has contacts near which cells can be refined. @throw InputError when it does not
void check_refinement(const Scene<2> &scene, const Settings &settings);

/**
 * @brief Small cells where bodies may come to touch others, walls and obstacles: 'Mesh/Refine near contact'.
 *
 * What a body may touch is at most one of the largest cells away from it at the start. A cell is cut when it
 * is at most two cells of the next size farther away from that than the nearest place of the body.
 *
 * @throw InputError as check_refinement() does
 */
LevelsOfScene refine_near_contact(const Scene<2> &scene, const Settings &settings, const Lattice<2> &lattice);
} // namespace softgrain::mpm

#endif
