// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_check_report_h
#define softgrain_app_check_report_h

#include <softgrain/app/trial.h>
#include <softgrain/model/forecast.h>

#include <iosfwd>
#include <optional>

namespace softgrain
{
class Input;

/**
 * @brief What `softgrain check` prints: the scene in numbers, sizes and cost, what would be written,
 * warnings.
 * @param outline, forecast where they are known
 * @param model exact sizes; null: those of the forecast
 * @param trial by which the forecast was corrected; its seconds are then those of this machine; null: none
 * was made
 * @param n_ranks for which the cost of one rank is said; 0: that of one process alone
 */
void print_check_report(std::ostream &out,
                        const Input &input,
                        const std::optional<RunOutline> &outline,
                        const std::optional<Forecast> &forecast,
                        const AnyModel *model,
                        const Trial *trial = nullptr,
                        unsigned int n_ranks = 0);

/// Length, steps, processor time and memory that a run is expected to take, on a machine as slow as
/// slowness_of_machine() says.
SizeReport cost_report(const RunOutline &outline, const Forecast &forecast, double slowness);

/// Prints which libraries of a file were left out, and what only they can know.
void print_left_out(std::ostream &out, const Input &input);
} // namespace softgrain

#endif
