// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/share_outlines.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
using Sketches = std::vector<MovedBoundary::Sketch>;

/// Moves the outlines of owned bodies and those that are driven; sketches of the others come here.
std::vector<MovedBoundary> move_own(const BodyShare &share, const OutlineScene &scene, Sketches &sketches)
{
  const std::vector<Body<2>> &bodies = scene.bodies;
  std::vector<MovedBoundary> boundaries(bodies.size());
  share.together(
      [&]()
      {
        parallel_for(bodies.size(), 8,
                     [&](const std::size_t begin, const std::size_t end)
                     {
                       for (std::size_t b = begin; b < end; ++b)
                         if (share.mine(b) || bodies[b].rigid.driven)
                         {
                           boundaries[b] = MovedBoundary(bodies[b], scene);
                           sketches[b] = boundaries[b].sketch();
                         }
                     });
      },
      [&](BodyShare::Message &message)
      {
        for (unsigned int b = 0; b < sketches.size(); ++b)
          message.add(b, sketches[b].data(), sketches[b].size());
      });
  for (unsigned int b = 0; b < bodies.size(); ++b)
    if (!boundaries[b].has_markers())
      boundaries[b] = MovedBoundary(bodies[b], sketches[b]);
  return boundaries;
}

/// Bodies whose outlines go from one owner to another, by the other one.
struct Travellers
{
  std::vector<std::vector<unsigned int>> leave, come;
};

Travellers travellers(const BodyShare &share, const OutlineScene &scene, const MovedOutlines &moved)
{
  Travellers found;
  found.leave.resize(share.exchange.number());
  found.come.resize(share.exchange.number());
  for (unsigned int b = 0; b < moved.tasks.size(); ++b)
    for (const ContactTask &task : moved.tasks[b])
      if (const unsigned int p = task.partner;
          share.mine(b) != share.mine(p) && !scene.bodies[p].rigid.driven)
        (share.mine(p) ? found.leave[share.owner(b)] : found.come[share.owner(p)]).push_back(p);
  for (auto *const lists : {&found.leave, &found.come})
    for (std::vector<unsigned int> &list : *lists)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  return found;
}

/// Room for the displacements of the markers of these bodies, by owner.
std::vector<std::vector<double>> room_for(const std::vector<std::vector<unsigned int>> &bodies_of_owners,
                                          const std::vector<Body<2>> &bodies)
{
  std::vector<std::vector<double>> room;
  for (const std::vector<unsigned int> &list : bodies_of_owners)
  {
    std::size_t n = 0;
    for (const unsigned int b : list)
      n += 2 * bodies[b].boundary.position.size();
    room.emplace_back(n);
  }
  return room;
}

} // namespace

MovedOutlines move_outlines(const OutlineScene &scene)
{
  MovedOutlines moved;
  moved.boundaries.resize(scene.bodies.size());
  parallel_for(scene.bodies.size(), 8,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   moved.boundaries[b] = MovedBoundary(scene.bodies[b], scene);
               });
  moved.folds = fold_into_cell(scene, moved.boundaries);
  moved.tasks = find_tasks(scene, moved.boundaries);
  return moved;
}

MovedOutlines share_outlines(const BodyShare &share, const OutlineScene &scene)
{
  const std::vector<Body<2>> &bodies = scene.bodies;
  Sketches sketches(bodies.size());
  MovedOutlines moved;
  moved.boundaries = move_own(share, scene, sketches);
  const Exchange::OwnWork own_work(share.exchange);
  // What travels is as it was before it was brought into a cell.
  const std::vector<MovedBoundary> as_moved =
      scene.cell != nullptr ? moved.boundaries : std::vector<MovedBoundary>();
  moved.folds = fold_into_cell(scene, moved.boundaries);
  moved.tasks = find_tasks(scene, moved.boundaries);

  const Travellers bodies_of = travellers(share, scene, moved);
  std::vector<std::vector<double>> leave = room_for(bodies_of.leave, bodies),
                                   come = room_for(bodies_of.come, bodies);
  for (unsigned int r = 0; r < leave.size(); ++r)
  {
    double *at = leave[r].data();
    for (const unsigned int b : bodies_of.leave[r])
      for (const dealii::Tensor<1, 2> &way :
           (as_moved.empty() ? moved.boundaries : as_moved)[b].marker_displacements())
        at = std::copy_n(way.begin_raw(), 2, at);
  }
  share.exchange.swap(leave, come);
  for (unsigned int r = 0; r < come.size(); ++r)
  {
    const double *at = come[r].data();
    for (const unsigned int b : bodies_of.come[r])
    {
      MovedBoundary boundary(bodies[b], sketches[b]);
      boundary.take_markers(scene, at);
      at += 2 * bodies[b].boundary.position.size();
      if (!moved.folds.empty())
        fold_back(scene, moved.folds[b], boundary);
      moved.boundaries[b] = std::move(boundary);
    }
  }
  return moved;
}
} // namespace softgrain::mpm
