// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>

namespace softgrain::mpm
{
std::vector<double> row_velocity(const World &world,
                                 const std::vector<Eigen::VectorXd> &v,
                                 const std::vector<WallMotion<2>> &motion,
                                 const std::vector<double> &start_relative,
                                 const double theta,
                                 const double dt,
                                 const bool reopen)
{
  const auto &rows = world.contact.contact_rows();
  const unsigned int components = world.contact.n_components();
  std::vector<double> q = world.contact.relative_velocity(world.bodies, v);
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    const bool plane = rows[r].partner == ContactRow<2>::none;
    const double wall = plane ? motion[rows[r].wall].velocity : 0.;
    q[r * components] -= wall;
    double predicted = rows[r].gap;
    if (theta < 1.)
      predicted += (1. - theta) * dt * (start_relative[r * components] - wall);
    if (predicted > 0. || reopen)
      q[r * components] += predicted / (theta * dt);
  }
  return q;
}
} // namespace softgrain::mpm
