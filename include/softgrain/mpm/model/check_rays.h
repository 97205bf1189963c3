// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_check_rays_h
#define softgrain_mpm_model_check_rays_h

#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/scene.h>

namespace softgrain::mpm
{
/// Whether a scene may have `Contact/Geometry` = `rays`. @throw InputError that names what it may not have
void check_rays(const Settings &settings);
} // namespace softgrain::mpm

#endif
