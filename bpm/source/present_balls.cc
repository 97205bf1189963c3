// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/ball_dynamics.h>
#include <softgrain/bpm/present_balls.h>

#include <cmath>

namespace softgrain::bpm
{
const contact::BallContacts &PresentBalls::rows() const
{
  return dynamics.rows;
}

const std::vector<double> &PresentBalls::gaps() const
{
  return dynamics.gap;
}

const std::vector<std::uint32_t> &PresentBalls::pairs() const
{
  return dynamics.pair_of_row;
}

double PresentBalls::penetration() const
{
  return dynamics.deepest;
}

std::size_t PresentBalls::lists_made() const
{
  return dynamics.n_lists;
}

double PresentBalls::attraction_of(const std::size_t pair) const
{
  const Balls &primaries = dynamics.primaries;
  const contact::BallList &list = dynamics.list;
  const auto &laws = dynamics.laws;
  const std::uint32_t a = list.a(pair), b = list.b(pair);
  if (laws.empty() || primaries.body[a] != primaries.body[b] || !laws[primaries.body[a]])
    return 0.;
  const BallDynamics::Vector &xa = primaries.position[a], &xb = primaries.position[b];
  return attraction_at(*laws[primaries.body[a]], std::hypot(xa[0] - xb[0], xa[1] - xb[1], xa[2] - xb[2]),
                       primaries.radius[a] + primaries.radius[b]);
}

std::size_t PresentBalls::deepest_row(const bool bodies_apart) const
{
  const Balls &primaries = dynamics.primaries;
  const contact::BallContacts &rows = dynamics.rows;
  const std::vector<double> &gap = dynamics.gap;
  std::size_t worst = rows.size();
  double least = 0.;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const bool inner =
        rows.b[row] < primaries.size() && primaries.body[rows.a[row]] == primaries.body[rows.b[row]];
    if (gap[row] < least && !(bodies_apart && inner))
    {
      least = gap[row];
      worst = row;
    }
  }
  return worst;
}
} // namespace softgrain::bpm
