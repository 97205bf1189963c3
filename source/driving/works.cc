// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/works.h>

namespace softgrain
{
double external_work(const Balance &balance,
                     const std::vector<Wall<2>> &walls,
                     const std::vector<Obstacle<2>> &obstacles)
{
  double sum = balance.work_beside_walls();
  for (const Wall<2> &wall : walls)
    sum += wall.book.work;
  for (const Obstacle<2> &obstacle : obstacles)
    sum += obstacle.work;
  return sum;
}

std::vector<std::pair<std::string, double>> columns_of_work(const Balance &balance,
                                                            const std::vector<Wall<2>> &walls,
                                                            const std::vector<Obstacle<2>> &obstacles,
                                                            const Workers &workers)
{
  std::vector<std::pair<std::string, double>> columns;
  const auto add = [&columns](const bool there, const std::string &name, const double work)
  {
    if (there)
      columns.emplace_back(name + "_work_J_per_m", work);
  };
  for (const Wall<2> &wall : walls)
    add(true, wall.description.name, wall.book.work);
  for (const Obstacle<2> &obstacle : obstacles)
    add(true, obstacle.description.name, obstacle.work);
  for (const std::string &load : workers.loads)
    add(true, load, balance.load_work.of(load));
  add(workers.driven_bodies, "driven_bodies", balance.driven_work);
  add(workers.growth, "growth", balance.growth_work);
  add(workers.cell, "cell", balance.cell_work);
  add(workers.adhesion, "adhesion", balance.adhesion_work);
  return columns;
}
} // namespace softgrain
