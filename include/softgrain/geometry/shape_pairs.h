// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_shape_pairs_h
#define softgrain_geometry_shape_pairs_h

#include <softgrain/geometry/periodic_cell.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace softgrain
{
/// overlap() of @p a and of @p b moved by @p shift [m].
bool overlap_when_moved(const Shape<2> &a,
                        const Shape<2> &b,
                        const dealii::Tensor<1, 2> &shift,
                        double tolerance);

/// overlap() of @p a and of @p b moved by @p shift [m]; what counts as touching is known there.
bool overlap_when_moved(const Shape<3> &a,
                        const Shape<3> &b,
                        const dealii::Tensor<1, 3> &shift,
                        double tolerance);

/**
 * @brief The first two shapes that overlap, directly or through the sides of a cell that repeats; nothing
 * when none do.
 *
 * Pairs come from a tree of boxes, so the time grows with n log n.
 * @param shapes   narrower than the cell in every direction that repeats
 * @param touching share of the size of the larger one that counts as touching
 * @return their numbers, the lower one first: of all such pairs the one whose higher number is the lowest
 */
template <int dim>
std::optional<std::pair<std::size_t, std::size_t>>
find_overlap(const std::vector<const Shape<dim> *> &shapes, const PeriodicCell<dim> &cell, double touching);
} // namespace softgrain

#endif
