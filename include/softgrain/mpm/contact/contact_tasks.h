// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_tasks_h
#define softgrain_mpm_contact_contact_tasks_h

#include <softgrain/mpm/contact/moved_boundary.h>

#include <algorithm>
#include <vector>

namespace softgrain::mpm
{
/// Gap up to which a row is needed where things come nearer by @p approach over the step: that way times
/// ContactScene::foresight, and what the walls may add when they hit what was at rest.
class ContactReach
{
public:
  /// @param way largest over the step of what is no wall and no body [m]
  ContactReach(const ContactScene<2> &scene, double way)
      : rest(0.1 * scene.cell_size + scene.adhesion_reach), foresight(scene.foresight)
  {
    for (const WallMotion<2> &wall : scene.walls)
      way = std::max(way, scene.dt * wall.fastest);
    rest += foresight * way;
  }

  double operator()(const double approach) const { return rest + foresight * approach; }

private:
  double rest;
  const double foresight;
};

/// What one of a pair of bodies does: the pair stands in the list of the one that looks.
struct ContactTask
{
  unsigned int partner;
  bool corners_only;
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

/// Who looks for contact with whom, by the body that looks, in an order that depends on nothing else; with
/// ContactScene::looking only lists of bodies of this rank are whole.
/// @throw ComputationError when a cell that repeats has become so small that a body meets itself
std::vector<std::vector<ContactTask>> find_tasks(const ContactScene<2> &scene,
                                                 const ContactReach &reach,
                                                 const std::vector<MovedBoundary> &boundaries);

/// Image @p image of a boundary in a cell that repeats.
MovedBoundary
image_of(const MovedBoundary &boundary, const PeriodicCell<2>::Image &image, const ContactScene<2> &scene);

/// Brings boundaries into the cell. @return the copy of it each was in; empty when nothing repeats
std::vector<PeriodicCell<2>::Image> fold_into_cell(const ContactScene<2> &scene,
                                                   std::vector<MovedBoundary> &boundaries);

/// Brings one into the cell that is in copy @p fold of it.
void fold_back(const ContactScene<2> &scene, const PeriodicCell<2>::Image &fold, MovedBoundary &boundary);
} // namespace softgrain::mpm

#endif
