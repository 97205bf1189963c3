// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_check_rays_h
#define softgrain_mpm_model_check_rays_h

#include <softgrain/mpm/model/settings.h>

namespace softgrain::mpm
{
/// Whether a solver tells how many directions lower the energy, as rays need it to find minima.
bool counts_negative_pivots(const LinearSolverSettings &solver);

/// @throw InputError for settings that do not go together with `Contact/Geometry` = `rays`
void check_rays(const Settings &settings);
} // namespace softgrain::mpm

#endif
