// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_folded_bodies_h
#define softgrain_driving_folded_bodies_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/geometry/periodic_cell.h>

#include <optional>
#include <vector>

namespace softgrain
{
/// Bodies of a snapshot that have been brought into the cell, whichever copy of it they had come to.
template <int dim>
class FoldedBodies
{
public:
  using Image = typename PeriodicCell<dim>::Image;

  /// Brings every body of @p snapshot, its outline and its points into the cell as a whole.
  FoldedBodies(Snapshot<dim> &snapshot, const PeriodicCell<dim> &cell);

  /**
   * @brief Does the same to a contact of two of them.
   * @param body_fold copy of the cell that its place has been taken back from already
   * @param image     of body_b that body_a meets, before bodies were brought into the cell
   */
  void fold(ContactState<dim> &contact, const Image &body_fold, const Image &image) const;

private:
  const PeriodicCell<dim> cell;
  std::vector<Image> copies; ///< in which a body was
};

/// Folds the bodies of @p snapshot into the cell between its walls; nothing when that does not repeat.
template <int dim>
std::optional<FoldedBodies<dim>> fold_bodies(Snapshot<dim> &snapshot);
} // namespace softgrain

#endif
