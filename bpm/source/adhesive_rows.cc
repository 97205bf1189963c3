// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that holds primaries of different bodies together.
#include <softgrain/bpm/dynamics.h>

#include <algorithm>
#include <cmath>

namespace softgrain::bpm
{
void Dynamics::find_pulls()
{
  pull.clear();
  if (!remembered.adhesion.acts())
    return;
  pull.resize(rows.size(), 0.);
  // Obstacles, whose rows are the last ones, do not adhere.
  const std::size_t n = primaries.size(), n_rows = rows.size() - obstacle_rows.size();
  for (std::size_t row = 0; row < n_rows; ++row)
  {
    const std::uint32_t a = primaries.body[rows.a[row]], b = rows.b[row];
    if (b < n && a == primaries.body[b])
      continue;
    const double strength =
        b < n ? settings.pairs.adhesion(a, primaries.body[b]) : settings.pairs.adhesion_at_wall(a, b - n);
    if (strength > 0.)
      pull[row] = strength * remembered.adhesion.share(key_of(row), gap[row]);
  }
}

void Dynamics::shift_cones(const double dt, const bool back)
{
  // The bodies move under the pulls first; what the contacts then add is P + c dt, which obeys Coulomb's law.
  for (std::size_t row = 0; row < pull.size(); ++row)
  {
    const double impulse = dt * pull[row];
    if (impulse == 0.)
      continue;
    if (back)
    {
      rows.impulse[row] -= impulse;
      continue;
    }
    const std::uint32_t a = rows.a[row], b = rows.b[row];
    for (unsigned int d = 0; d < 2; ++d)
    {
      bodies.velocity[a][d] -= bodies.inverse_mass[a] * impulse * rows.normal[row][d];
      bodies.velocity[b][d] += bodies.inverse_mass[b] * impulse * rows.normal[row][d];
    }
    rows.impulse[row] += impulse;
  }
  // What was held by more in the step before starts from nothing.
  for (std::size_t row = 0; row < pull.size() && !back; ++row)
    rows.impulse[row] = std::max(0., rows.impulse[row]);
}

double Dynamics::adhesion_work(const double dt, const std::vector<Wall<2>> &walls) const
{
  // With the mean of the velocities before and after, as all work of a step.
  const std::size_t n = primaries.size();
  double work = 0.;
  for (std::size_t row = 0; row < pull.size(); ++row)
    if (pull[row] > 0.)
    {
      const std::uint32_t a = rows.a[row], b = rows.b[row];
      double opening = 0.;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double before =
            b < n ? primaries.velocity[b][d] : walls[b - n].speed * walls[b - n].normal()[d];
        opening += rows.normal[row][d] *
                   (primaries.velocity[a][d] + bodies.velocity[a][d] - before - bodies.velocity[b][d]);
      }
      work -= 0.5 * dt * pull[row] * opening;
    }
  return work;
}

void Dynamics::note_contacts(const double dt)
{
  if (!remembered.adhesion.remembers())
    return;
  constexpr double near_limit = 1. - 1e-6; // of friction: solvers have tolerances
  const std::size_t n = primaries.size();
  for (std::size_t row = 0; row < rows.size() - obstacle_rows.size(); ++row)
  {
    const std::uint32_t a = rows.a[row], b = rows.b[row];
    if (b < n && primaries.body[a] == primaries.body[b])
      continue;
    double opening = 0.;
    for (unsigned int d = 0; d < 2; ++d)
      opening += rows.normal[row][d] * (bodies.velocity[a][d] - bodies.velocity[b][d]);
    const double closing = rows.impulse[row] + dt * pull[row];
    const bool slides = rotations && closing > 0. && rows.friction[row] > 0. &&
                        std::abs(rows.tangential_impulse[row]) >= near_limit * rows.friction[row] * closing;
    remembered.adhesion.note(key_of(row), gap[row], {gap[row] + dt * opening, closing > 0., slides, dt});
  }
  remembered.adhesion.finish_step();
}
} // namespace softgrain::bpm
