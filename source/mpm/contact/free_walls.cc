// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/free_walls.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
void FreeWalls<dim>::reinit(const std::vector<ContactRow<dim>> &rows, const unsigned int components)
{
  n_components = components;
  n_rows = rows.size();
  of_wall.assign(list.size(), {});
  stop_wall.clear();
  for (unsigned int k = 0; k < list.size(); ++k)
  {
    for (unsigned int r = 0; r < rows.size(); ++r)
      if (list[k].is_side())
        // The cell closes on all that is in it, in proportion.
        for (unsigned int c = 0; c < components; ++c)
        {
          const double factor = list[k].way * direction_of(rows[r], c) *
                                (list[k].normal * rows[r].cell.branch / list[k].length);
          if (factor != 0.)
            of_wall[k].push_back({r * components + c, factor});
        }
      else if (rows[r].wall == list[k].wall)
        for (unsigned int c = 0; c < components; ++c)
        {
          // Rows of a plane have its normal; those of a slab have that of its outline.
          const double factor = list[k].way * direction_of(rows[r], c);
          if (factor != 0.)
            of_wall[k].push_back({r * components + c, factor});
        }
    if (list[k].stop > 0.)
      for (const double factor : {1., -1.})
      {
        of_wall[k].push_back({static_cast<unsigned int>((n_rows + stop_wall.size()) * components), factor});
        stop_wall.push_back(k);
      }
  }
  stops = stop_wall.size();
}

template <int dim>
void FreeWalls<dim>::add_blocks(contact::BlockDelassus &W) const
{
  for (unsigned int k = 0; k < list.size(); ++k)
  {
    if (of_wall[k].empty())
      continue;
    std::vector<unsigned int> components;
    Eigen::VectorXd factor(of_wall[k].size());
    for (const Entry &entry : of_wall[k])
    {
      factor[components.size()] = entry.factor;
      components.push_back(entry.component);
    }
    W.add_block(components, Eigen::MatrixXd(factor * factor.transpose() / list[k].mass));
  }
  // Nothing moves along a stop; a matrix without zero rows is easier to factorise.
  for (unsigned int s = 0; s < stops; ++s)
    for (unsigned int c = 1; c < n_components; ++c)
      W.add_block({(n_rows + s) * n_components + c},
                  Eigen::MatrixXd::Constant(1, 1, 1. / list[stop_wall[s]].mass));
}

template <int dim>
void FreeWalls<dim>::add_stops(std::vector<double> &free_velocity) const
{
  free_velocity.resize((n_rows + stops) * n_components, 0.);
  for (unsigned int s = 0; s < stops; ++s)
  {
    const FreeWall<dim> &wall = list[stop_wall[s]];
    free_velocity[(n_rows + s) * n_components] =
        wall.stop + (s % 2 == 0 ? -wall.free_speed : wall.free_speed);
  }
}

template <int dim>
double FreeWalls<dim>::tolerance_factor(const std::vector<double> &free_velocity) const
{
  if (stops == 0)
    return 1.;
  std::vector<double> stopped = free_velocity;
  double least = list[stop_wall[0]].stop;
  for (unsigned int k = 0; k < list.size(); ++k)
  {
    const double beyond = list[k].free_speed - std::clamp(list[k].free_speed, -list[k].stop, list[k].stop);
    least = std::min(least, list[k].stop);
    for (const Entry &entry : of_wall[k])
      stopped[entry.component] += entry.factor * beyond;
  }
  double with = 0., without = 0.;
  for (unsigned int i = 0; i < free_velocity.size(); i += n_components)
  {
    with = std::max(with, -free_velocity[i]);
    without = std::max(without, -stopped[i]);
  }
  return with > 0. ? std::clamp(std::max(without, 0.1 * least) / with, 1e-6, 1.) : 1.;
}

template <int dim>
void FreeWalls<dim>::move(const std::vector<double> &impulse)
{
  for (unsigned int k = 0; k < list.size(); ++k)
  {
    double given = 0.;
    for (const Entry &entry : of_wall[k])
      given += entry.factor * impulse[entry.component];
    list[k].speed = list[k].free_speed - given / list[k].mass;
  }
}

template class FreeWalls<2>;
template class FreeWalls<3>;
} // namespace softgrain::mpm
