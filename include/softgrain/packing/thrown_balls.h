// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_thrown_balls_h
#define softgrain_packing_thrown_balls_h

#include <softgrain/base/random.h>

#include <array>
#include <vector>

namespace softgrain
{
/**
 * @brief Places of balls, in the plane disks, that are thrown into a box about the origin at random without
 * overlap, the largest first.
 *
 * @param half of the edges of the box [m] @param periodic directions without walls
 * @throw InputError when they do not fit
 */
template <int dim>
std::vector<std::array<double, dim>> thrown_balls(const std::vector<double> &radius,
                                                  const std::array<double, dim> &half,
                                                  const std::array<bool, dim> &periodic,
                                                  Uniform &random);
} // namespace softgrain

#endif
