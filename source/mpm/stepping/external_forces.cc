// SPDX-License-Identifier: LGPL-2.1-or-later
// Apart from external_force(), which the compiler would else copy to both of the calls below: it may round
// differently in each.
#include <softgrain/mpm/stepping/external_force.h>

#include <algorithm>

namespace softgrain::mpm
{
std::vector<Eigen::VectorXd> external_forces(const std::vector<Body<2>> &bodies,
                                             const BodyShare &share,
                                             const dealii::Tensor<1, 2> &gravity,
                                             const double time)
{
  std::vector<Eigen::VectorXd> forces(bodies.size());
  const auto load = [&](const Body<2> &body)
  {
    if (!external_force(body, gravity, time, forces[body.index]))
      forces[body.index].resize(0);
  };
  const auto is_pushed = [](const Body<2> &body) { return !body.driven && !body.body_force.empty(); };
  if (share.alone() || std::any_of(bodies.begin(), bodies.end(), is_pushed))
    share.for_mine(bodies, load,
                   [&](BodyShare::Message &message)
                   {
                     for (const Body<2> &body : bodies)
                       if (is_pushed(body) || (!body.driven && gravity.norm_square() > 0.))
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
                     if (!bodies[b].driven)
                       load(bodies[b]);
                 });
  return forces;
}
} // namespace softgrain::mpm
