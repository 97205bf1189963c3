// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_space_checks_h
#define softgrain_scene_space_checks_h

#include <softgrain/base/mistakes.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/scene.h>

#include <string>

namespace softgrain
{
/**
 * @brief Looks at a scene in space before anything is computed.
 *
 * Every parameter that would ask for what is not there yet, and every one that would have no effect, must
 * stand at its default.
 *
 * @param parameters all of the file
 * @throw InputErrors with a line for each that does not, and for what does not fit together
 */
void check_scene_in_space(const Scene<3> &scene, const ParameterSection &parameters);

/// How walls are driven, alone: for the stages of a run.
/// @throw InputError as check_scene_in_space()
void check_walls_in_space(const Scene<3> &scene, const ParameterSection &parameters);

/// Adds what is wrong with walls to a list.
void check_walls_in_space(const Scene<3> &scene, const ParameterSection &parameters, Mistakes &mistakes);

/// What a file says of an entry of a section, or, without one, of its own; empty where it has none.
std::string value_in(const ParameterSection &parameters, const std::string &section, const std::string &name);
} // namespace softgrain

#endif
