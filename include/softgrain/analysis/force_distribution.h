// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_force_distribution_h
#define softgrain_analysis_force_distribution_h

#include <optional>
#include <vector>

namespace softgrain
{
/// beta of the force distribution whose mean is one @cite nguyen2016, eq. (2.33).
double force_distribution_beta(double gamma);

/// Probability density of a force @p f, in units of the mean force @cite nguyen2016, eq. (2.32).
double force_distribution(double f, double gamma);

/**
 * @brief gamma of @cite nguyen2016, eqs. (2.32)-(2.33) by maximum likelihood, without bins.
 * @param forces in units of their mean
 * @return nothing for fewer than 20 forces, or when no gamma between 1e-6 and 1e3 is better than both ends:
 * forces nearly all alike, or spread at least as an exponential
 */
std::optional<double> fit_force_distribution(const std::vector<double> &forces);
} // namespace softgrain

#endif
