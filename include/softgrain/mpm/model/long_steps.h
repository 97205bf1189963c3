// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_long_steps_h
#define softgrain_mpm_model_long_steps_h

#include <softgrain/mpm/model/settings.h>

namespace softgrain::mpm
{
/// CFL steps beyond which a step does not resolve waves.
constexpr double resolves_waves_to = 20.5;

/// What is best where a step does not resolve waves and inertia hardly holds what contacts do not, unless it
/// is given; nothing for schemes that know no waves. @param step, cfl_step the step that is wanted, and in
/// which a wave goes through a cell [s]
inline void choose_for_long_steps(const double step, const double cfl_step, Settings &settings)
{
  if (settings.scheme.ends_in_balance() || !settings.follows_contact())
    return;
  if (settings.theta == 0. && step > resolves_waves_to * cfl_step)
    settings.scheme = TimeScheme::create(settings.scheme.name, 0.8);
}
} // namespace softgrain::mpm

#endif
