// SPDX-License-Identifier: LGPL-2.1-or-later
// How World finds contact rows.
#include <softgrain/mpm/model/world.h>

#include <deal.II/base/timer.h>

#include <utility>

namespace softgrain::mpm
{
namespace
{
/// What a search for contact reads; it refers to all that is handed in.
ContactScene<2> contact_scene(const World &world,
                              const std::vector<WallMotion<2>> &motion,
                              const double dt,
                              const std::vector<Eigen::VectorXd> *increment,
                              const double share,
                              const std::optional<CellMotion> &cell)
{
  ContactScene<2> scene{world.bodies,
                        motion,
                        world.pairs,
                        dt,
                        world.lattice->cell_size(),
                        increment,
                        share,
                        world.places_are_free(),
                        world.adhesion.reach()};
  scene.obstacles = world.obstacles.empty() ? nullptr : &world.obstacles;
  scene.cell = cell ? &*cell : nullptr;
  return scene;
}
} // namespace

void World::find_rows(const std::vector<WallMotion<2>> &motion,
                      const double dt,
                      const std::vector<Eigen::VectorXd> *increment,
                      const double share,
                      const bool again,
                      const GapsByRow *start_gaps)
{
  dealii::TimerOutput::Scope section(*timer, "contact search");
  std::vector<ContactRow<2>> rows;
  const std::optional<CellMotion> cell = cell_motion(motion);
  ContactScene<2> where = contact_scene(*this, motion, dt, increment, share, cell);
  if (again)
    where.foresight = 0.5; // the next search sees what this one leaves out
  geometry->find(where, rows);
  if (start_gaps != nullptr)
    for (ContactRow<2> &row : rows)
    {
      const auto gap = start_gaps->find(row.key);
      if (gap != start_gaps->end())
        row.gap = gap->second;
    }
  if (pairs.adhere())
    for (ContactRow<2> &row : rows)
      // The impulse of newmark is half a step of the force at its end.
      row.pull = (settings.scheme.stored_acceleration ? 0.5 : 1.) * row.adhesion * row.length *
                 (row.adhesion > 0. ? adhesion.share(row.key, row.gap) : 0.);
  contact.reinit(std::move(rows), bodies, dt, again);
}

GapsByRow World::true_gaps(const std::vector<WallMotion<2>> &motion,
                           const double dt,
                           const std::vector<Eigen::VectorXd> &increment,
                           const double share) const
{
  dealii::TimerOutput::Scope section(*timer, "contact search");
  std::vector<ContactRow<2>> rows;
  const std::optional<CellMotion> cell = cell_motion(motion);
  const ContactScene<2> where = contact_scene(*this, motion, dt, &increment, share, cell);
  geometry->find(where, rows);
  GapsByRow gaps;
  gaps.reserve(rows.size());
  for (const ContactRow<2> &row : rows)
    gaps[row.key] = row.gap_where_found;
  return gaps;
}
} // namespace softgrain::mpm
