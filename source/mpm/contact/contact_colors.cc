// SPDX-License-Identifier: LGPL-2.1-or-later
// Which bodies take part in which components of a contact system, and which pairs can be solved at once.
#include <softgrain/mpm/contact/contact_system.h>

#include <algorithm>

namespace softgrain::mpm
{
template <int dim>
void ContactSystem<dim>::list_components(const std::vector<Body<dim>> &bodies)
{
  body_components.resize(bodies.size());
  for (std::vector<unsigned int> &list : body_components)
    list.clear();
  rows_at_driven.clear();
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const auto take = [&](const unsigned int b)
    {
      if (b == ContactRow<dim>::none)
        return;
      if (bodies[b].rigid.driven)
        rows_at_driven.push_back(r);
      else
        for (unsigned int c = 0; c < n_components(); ++c)
          body_components[b].push_back(r * n_components() + c);
    };
    take(rows[r].body);
    if (rows[r].partner != rows[r].body)
      take(rows[r].partner);
  }
  component_start.assign(1, 0);
  for (const std::vector<unsigned int> &list : body_components)
    component_start.push_back(component_start.back() + list.size());
}

template <int dim>
void ContactSystem<dim>::color(const std::vector<unsigned int> &taking,
                               const contact::Problem::Range range,
                               std::vector<std::vector<char>> &taken)
{
  unsigned int color = 0;
  while (std::any_of(taking.begin(), taking.end(),
                     [&](const unsigned int i) { return color < taken[i].size() && taken[i][color]; }))
    ++color;
  for (const unsigned int i : taking)
  {
    taken[i].resize(std::max<std::size_t>(taken[i].size(), color + 1), 0);
    taken[i][color] = 1;
  }
  if (color == problem.colors.size())
    problem.colors.emplace_back();
  problem.colors[color].push_back(range);
}

template <int dim>
void ContactSystem<dim>::color_pairs(const std::vector<Body<dim>> &bodies)
{
  // Each pair gets the first colour that nothing it moves has yet: bodies, and free walls after them.
  problem.colors.clear();
  std::vector<std::vector<char>> taken(bodies.size() + free_walls.list.size());
  for (unsigned int first = 0, end; first < rows.size(); first = end)
  {
    end = first + 1;
    while (end < rows.size() && rows[end].body == rows[first].body &&
           rows[end].partner == rows[first].partner && rows[end].wall == rows[first].wall &&
           rows[end].cell.image == rows[first].cell.image)
      ++end;
    std::vector<unsigned int> pair;
    for (const unsigned int b : {rows[first].body, rows[first].partner})
      if (b != ContactRow<dim>::none && !bodies[b].rigid.driven)
        pair.push_back(b);
    for (unsigned int k = 0; k < free_walls.list.size(); ++k)
      if (rows[first].wall == free_walls.list[k].wall || free_walls.list[k].length > 0.)
        pair.push_back(bodies.size() + k);
    color(pair, {first, end}, taken);
  }
  for (unsigned int s = 0; s < free_walls.n_stops(); ++s)
    color({static_cast<unsigned int>(bodies.size() + free_walls.wall_of_stop(s))},
          {static_cast<unsigned int>(rows.size() + s), static_cast<unsigned int>(rows.size() + s + 1)},
          taken);
}

template void ContactSystem<2>::list_components(const std::vector<Body<2>> &);
template void ContactSystem<2>::color(const std::vector<unsigned int> &,
                                      contact::Problem::Range,
                                      std::vector<std::vector<char>> &);
template void ContactSystem<2>::color_pairs(const std::vector<Body<2>> &);
template void ContactSystem<3>::list_components(const std::vector<Body<3>> &);
template void ContactSystem<3>::color(const std::vector<unsigned int> &,
                                      contact::Problem::Range,
                                      std::vector<std::vector<char>> &);
template void ContactSystem<3>::color_pairs(const std::vector<Body<3>> &);
} // namespace softgrain::mpm
