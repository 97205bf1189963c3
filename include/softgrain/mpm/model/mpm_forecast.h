// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_mpm_forecast_h
#define softgrain_mpm_model_mpm_forecast_h

#include <softgrain/constitutive/law.h>
#include <softgrain/model/forecast.h>
#include <softgrain/mpm/model/settings.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Points, steps, memory and processor time of a run, and what the studies say of its settings.
 *
 * Memory and time follow from the number of points and the width of the bodies' matrices. The constants were
 * fitted to the shipped scenes; doc/results/forecast.md has the comparison.
 * @param laws one per material
 */
Forecast forecast(const Scene<2> &scene,
                  const Settings &settings,
                  const std::vector<std::shared_ptr<const constitutive::Law<2>>> &laws,
                  const RunOutline &run);
} // namespace softgrain::mpm

#endif
