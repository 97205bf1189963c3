// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_capabilities_h
#define softgrain_mpm_model_capabilities_h

#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/scene.h>

namespace softgrain::mpm
{
/// Whether the time scheme and the contact geometry of @p settings can do all that @p scene asks for: one
/// table of capabilities, from which the first line that does not fit is told. @throw InputError
void check_capabilities(const Scene<2> &scene, const Settings &settings);
/// Whether they can do it in space. @throw InputError
void check_capabilities(const Scene<3> &scene, const Settings &settings);
} // namespace softgrain::mpm

#endif
