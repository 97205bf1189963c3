// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_image_pairs_h
#define softgrain_mpm_contact_image_pairs_h

#include <softgrain/geometry/periodic_cell.h>

#include <deal.II/base/bounding_box.h>

#include <vector>

namespace softgrain::mpm
{
/// Two things of which one meets an image of the other, across a side of the cell.
template <int dim>
struct ImagePair
{
  unsigned int a, b;
  typename PeriodicCell<dim>::Image image; ///< of b, that a meets
};

/**
 * @brief Pairs of boxes that overlap across the sides of the cell, each once.
 * @param boxes around things whose centres lie in the cell, which are smaller than it
 * @return in an order that depends on nothing else; a pair of a thing with itself when the cell is too small
 */
template <int dim>
std::vector<ImagePair<dim>> pairs_across(const std::vector<dealii::BoundingBox<dim>> &boxes,
                                         const PeriodicCell<dim> &cell);
} // namespace softgrain::mpm

#endif
