// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/history_columns.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/driving/works.h>

#include <map>
#include <string>

namespace softgrain
{
namespace
{
/// Name of the column of a work, as columns_of_work() has it.
std::string column_of_work(const std::string &name)
{
  return name + "_work_J_per_m";
}

/// Columns of works that have the same names in all scenes, and what is said of each.
std::map<std::string, std::string> works_of_all_scenes()
{
  std::map<std::string, std::string> columns;
  Workers all{true, true, true, true, Registry<Load<2>>::instance().names()};
  all.loads.push_back(name_of_body_force);
  for (const auto &[column, value] : columns_of_work(Balance(), {}, {}, all))
    columns[column] = "has a meaning of its own";
  columns[column_of_work("external")] = "is the sum of all works";
  columns[column_of_work("regularisation")] = "has a meaning of its own";
  return columns;
}
} // namespace

void check_history_columns(const Scene<2> &scene)
{
  std::map<std::string, std::string> taken = works_of_all_scenes();
  Mistakes mistakes;
  const auto take = [&](const std::string &section, const std::string &name)
  {
    const std::string column = column_of_work(name);
    const auto [there, is_new] = taken.emplace(column, "is that of '" + section + "/" + name + "'");
    if (!is_new)
      mistakes.add(InputError("'" + section + "/Names': '" + name + "' is not allowed: the column '" +
                              column + "' of history.csv " + there->second + ": choose another name"));
  };
  for (const WallDescription<2> &wall : scene.walls)
    take("Walls", wall.name);
  for (const ObstacleDescription<2> &obstacle : scene.obstacles)
    take("Obstacles", obstacle.name);
  mistakes.end();
}

ContactLoads contact_loads(const std::vector<LoadWish> &wishes, const Scene<2> &scene)
{
  std::vector<std::string> bodies, walls, obstacles;
  std::vector<char> repeats;
  for (const BodyDescription<2> &body : scene.bodies)
    bodies.push_back(body.name);
  for (const WallDescription<2> &wall : scene.walls)
  {
    walls.push_back(wall.name);
    repeats.push_back(wall.type == WallDescription<2>::Type::periodic);
  }
  for (const ObstacleDescription<2> &obstacle : scene.obstacles)
    obstacles.push_back(obstacle.name);
  return ContactLoads(wishes, bodies, walls, obstacles, repeats);
}
} // namespace softgrain
