// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
template <int dim>
double Opening::share(const Body<dim> &body, const double dt) const
{
  if (length == 0.)
    return 1.;
  const double crossed = dt * std::sqrt(body.material.law->young_modulus() / body.material.density) / length;
  return std::min(1., crossed * crossed);
}

template double Opening::share(const Body<2> &, double) const;
template double Opening::share(const Body<3> &, double) const;

std::vector<double>
relative_velocity(const State &state, const Workspace &work, const std::vector<Eigen::VectorXd> &nodal)
{
  return work.contact.relative_velocity(work.share, state.bodies, work.drive,
                                        [&](const unsigned int b) -> const Eigen::VectorXd &
                                        { return nodal[b]; });
}

double way_of_partner(const ContactRow<2> &row,
                      const std::vector<WallMotion<2>> &motion,
                      const unsigned int component,
                      const double dt)
{
  if (row.velocity_of_place)
    return dt * *row.velocity_of_place * direction_of(row, component);
  // Slabs that are driven move in relative_velocity() already.
  const bool plane = row.partner == ContactRow<2>::none;
  return plane && component == 0 ? dt * motion[row.wall].velocity : 0.;
}

double parting_at_work(const ContactRow<2> &row,
                       const std::vector<WallMotion<2>> &motion,
                       const unsigned int component,
                       double relative)
{
  const dealii::Tensor<1, 2> direction = direction_of(row, component);
  if (row.velocity_of_place)
    return relative - *row.velocity_of_place * direction;
  if (row.wall == ContactRow<2>::none)
    return relative;
  // Slabs move in relative_velocity() already, planes do not.
  const bool plane = row.partner == ContactRow<2>::none;
  const WallMotion<2> &moves = motion[row.wall];
  relative -= ((plane ? 0. : -moves.velocity) + moves.rate) * (moves.normal * direction);
  if (plane && moves.slide != 0.)
    relative -= moves.slide * (moves.tangent() * direction);
  return relative;
}

std::vector<double> row_velocity(const State &state,
                                 const Workspace &work,
                                 const std::vector<Eigen::VectorXd> &v,
                                 const std::vector<WallMotion<2>> &motion,
                                 const std::vector<double> &start_relative,
                                 const double theta,
                                 const double dt,
                                 const Opening &opening,
                                 const bool with_impulses)
{
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  std::vector<double> q = relative_velocity(state, work, v);
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    double start = way_of_partner(rows[r], motion, 0, 1.), end = start;
    for (unsigned int c = 1; c < components; ++c)
      q[r * components + c] -= way_of_partner(rows[r], motion, c, 1.);
    for (const FreeWall<2> &free : work.contact.free_walls.list)
      if (free.wall == rows[r].wall)
      {
        const double moves = with_impulses ? free.speed : free.free_speed;
        for (unsigned int c = 1; c < components; ++c)
          q[r * components + c] -= moves * (free.way * direction_of(rows[r], c));
        start = free.start_speed * (free.way * rows[r].normal);
        end = moves * (free.way * rows[r].normal);
      }
    q[r * components] -= end;
    double predicted = rows[r].gap;
    if (opening.opens && predicted < 0.)
      predicted *= opening.share(state.bodies[rows[r].body], dt);
    if (theta < 1.)
      predicted += (1. - theta) * dt * (start_relative[r * components] - start);
    if (predicted > 0. || opening.opens)
      q[r * components] += predicted / (theta * dt);
  }
  return q;
}
} // namespace softgrain::mpm
