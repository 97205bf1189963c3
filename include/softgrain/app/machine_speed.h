// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_machine_speed_h
#define softgrain_app_machine_speed_h

namespace softgrain
{
/**
 * @brief How much longer this machine takes than the one that the constants of forecasts were fitted
 * on.
 *
 * It is measured: a small dense factorisation and sums over scattered numbers, the two kinds of work that
 * runs consist of, take some hundredths of a second. Both fit into the caches of one core.
 */
double slowness_of_machine();
} // namespace softgrain

#endif
