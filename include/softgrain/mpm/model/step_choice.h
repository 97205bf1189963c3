// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_step_choice_h
#define softgrain_mpm_model_step_choice_h

#include <softgrain/driving/wall.h>
#include <softgrain/mpm/model/settings.h>

#include <vector>

namespace softgrain::mpm
{
/// Declares the section `Time`.
void declare_time_parameters(dealii::ParameterHandler &prm);

/**
 * @brief Reads the section `Time` into @p settings.
 *
 * Where it gives none of `Time step`, `CFL multiple` and `Wall way`, the fastest wall goes a tenth of a cell
 * in a step: doc/results/trade.md compares that with steps by waves. Explicit schemes keep theirs, which
 * waves limit.
 * @throw InputError
 */
void parse_time_parameters(dealii::ParameterHandler &prm, Settings &settings);

/// Whether all of @p walls are told how to move, so that none swings under a pressure or a shear stress.
bool all_are_told(const std::vector<Wall<2>> &walls);
} // namespace softgrain::mpm

#endif
