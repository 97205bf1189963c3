// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_bpm_forecast_h
#define softgrain_bpm_bpm_forecast_h

#include <softgrain/bpm/attraction.h>
#include <softgrain/bpm/settings.h>
#include <softgrain/model/forecast.h>

#include <memory>
#include <vector>

namespace softgrain::bpm
{
/**
 * @brief Primaries, steps, memory and processor time of a run, and what the studies say of its step.
 *
 * The constants were fitted to the shipped scenes; doc/results/forecast.md has the comparison.
 * @param laws one per material
 */
Forecast forecast(const Scene<2> &scene,
                  const Settings &settings,
                  const std::vector<std::shared_ptr<const Attraction>> &laws,
                  const RunOutline &run);

/// Area that the outlines of the aggregates will enclose: primaries do not reach the edge of a shape [m^2].
double solid_area(const Settings &settings, const Crowd &crowd);
} // namespace softgrain::bpm

#endif
