// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_bisection_h
#define softgrain_geometry_bisection_h

#include <deal.II/base/point.h>

#include <vector>

namespace softgrain
{
/**
 * @brief Shares things out by where they are: recursive bisection across the longer side of the box around
 * them, so that weights are even.
 *
 * The result depends on the arguments alone. No part is left empty as long as there are enough things.
 * @param centers one per thing [m]
 * @param weights how much each counts, not negative
 * @param n_parts at least 1
 * @return the part of each thing
 */
template <int dim>
std::vector<unsigned int> bisect(const std::vector<dealii::Point<dim>> &centers,
                                 const std::vector<double> &weights,
                                 unsigned int n_parts);
} // namespace softgrain

#endif
