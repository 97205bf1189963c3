// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_tasks_h
#define softgrain_mpm_contact_contact_tasks_h

#include <softgrain/mpm/contact/moved_boundary.h>

#include <vector>

namespace softgrain::mpm
{
/// One of a pair of bodies that may have met in a step: the pair stands in the list of the one that looks.
struct ContactTask
{
  unsigned int partner;
  PeriodicCell<2>::Image image{}; ///< of the partner

  bool operator<(const ContactTask &task) const
  {
    return partner != task.partner ? partner < task.partner : image < task.image;
  }
};

/// Outlines on their way in a step, and who looks for contact with whom.
struct MovedOutlines
{
  std::vector<MovedBoundary> boundaries;
  std::vector<PeriodicCell<2>::Image> folds;   ///< as of fold_into_cell()
  std::vector<std::vector<ContactTask>> tasks; ///< as of find_tasks()
};

/// Pairs whose boxes meet on their ways, by the body that looks, in an order that depends on nothing else;
/// with OutlineScene::looking only lists of owned bodies are whole.
/// @throw ComputationError when a cell that repeats has become so small that a body meets itself
std::vector<std::vector<ContactTask>> find_tasks(const OutlineScene &scene,
                                                 const std::vector<MovedBoundary> &boundaries);

/// Image @p image of a boundary in a cell that repeats.
MovedBoundary
image_of(const MovedBoundary &boundary, const PeriodicCell<2>::Image &image, const OutlineScene &scene);

/// Brings boundaries into the cell. @return the copy of it each was in; empty when nothing repeats
std::vector<PeriodicCell<2>::Image> fold_into_cell(const OutlineScene &scene,
                                                   std::vector<MovedBoundary> &boundaries);

/// Brings one into the cell that is in copy @p fold of it.
void fold_back(const OutlineScene &scene, const PeriodicCell<2>::Image &fold, MovedBoundary &boundary);
} // namespace softgrain::mpm

#endif
