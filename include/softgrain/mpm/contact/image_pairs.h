// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_image_pairs_h
#define softgrain_mpm_contact_image_pairs_h

#include <softgrain/geometry/periodic_cell.h>

#include <deal.II/base/bounding_box.h>

#include <vector>

namespace softgrain::mpm
{
/// Two things of which one meets an image of the other, across a side of the cell.
struct ImagePair
{
  unsigned int a, b;
  PeriodicCell<2>::Image image; ///< of b, that a meets
};

/**
 * @brief Pairs of boxes that overlap across the sides of the cell, each once.
 * @param boxes around things whose centres lie in the cell, which are smaller than it
 * @return in an order that depends on nothing else; a pair of a thing with itself when the cell is too small
 */
std::vector<ImagePair> pairs_across(const std::vector<dealii::BoundingBox<2>> &boxes,
                                    const PeriodicCell<2> &cell);
} // namespace softgrain::mpm

#endif
