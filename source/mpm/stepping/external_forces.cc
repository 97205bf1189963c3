// SPDX-License-Identifier: LGPL-2.1-or-later
// Apart from external_force(), which the compiler would else copy to both of the calls below: it may round
// differently in each.
#include <softgrain/mpm/stepping/external_force.h>

#include <algorithm>

namespace softgrain::mpm
{
std::vector<Eigen::VectorXd>
external_forces(const std::vector<Body<2>> &bodies, const BodyShare &share, const LoadTimes &times)
{
  std::vector<Eigen::VectorXd> forces(bodies.size());
  const auto load = [&](const Body<2> &body)
  {
    if (!external_force(body, times, forces[body.index]))
      forces[body.index].resize(0);
  };
  // Points lie with the owner, and so do places of nodes.
  const auto is_for_one = [](const Body<2> &body)
  { return !body.rigid.driven && (body.loads.look_at_points() || body.loads.see_velocity()); };
  if (share.alone() || std::any_of(bodies.begin(), bodies.end(), is_for_one))
    share.for_mine(bodies, load,
                   [&](BodyShare::Message &message)
                   {
                     for (const Body<2> &body : bodies)
                       if (!body.rigid.driven && !body.loads.empty())
                       {
                         forces[body.index].conservativeResize(body.field.n_dofs());
                         message.add(body.index, forces[body.index].data(), forces[body.index].size());
                       }
                   });
  else
    parallel_for(bodies.size(), 1,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   for (std::size_t b = begin; b < end; ++b)
                     if (!bodies[b].rigid.driven)
                       load(bodies[b]);
                 });
  return forces;
}
} // namespace softgrain::mpm
