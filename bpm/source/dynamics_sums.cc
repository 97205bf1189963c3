// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that adds up: exactly, so that no sum depends on who has which primaries.
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/dynamics_sums.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace softgrain::bpm
{
namespace
{
/// Primaries that a thread takes at a time.
constexpr std::size_t grain = 4096;
} // namespace

std::vector<ExactSum> Dynamics::sums_of_motion() const
{
  std::vector<ExactSum> sums(4);
  for (std::size_t i = 0; i < n_own(); ++i)
  {
    const std::array<double, 2> &v = primaries.velocity[i];
    sums[1].add(primaries.mass[i] * std::hypot(v[0], v[1]));
    if (inverse_mass[i] == 0.)
      continue;
    const double spin = rotations ? primaries.radius[i] * primaries.angular_velocity[i] : 0.;
    sums[0].add(0.5 * primaries.mass[i] * (v[0] * v[0] + v[1] * v[1] + 0.5 * spin * spin));
    for (unsigned int d = 0; d < 2; ++d)
      sums[2 + d].add(primaries.mass[i] * v[d]);
  }
  return sums;
}

DynamicsSums Dynamics::sum_motion() const
{
  const std::vector<ExactSum> sums = sums_of_motion();
  DynamicsSums result;
  result.kinetic = sums[0].value();
  result.moving = sums[1].value();
  result.momentum = dealii::Tensor<1, 2>({sums[2].value(), sums[3].value()});
  return result;
}

DynamicsSums Dynamics::sums() const
{
  DynamicsSums sums = share ? totals : sum_motion();
  sums.attraction = stored_energy;
  if (share)
    return sums;
  sums.n_pairs = list.n_pairs();
  sums.n_contacts = rows.size();
  for (std::size_t row = 0; row < rows.size(); ++row)
    sums.n_pushing += carries_force(row);
  return sums;
}

void Dynamics::sum_up()
{
  std::vector<ExactSum> sums = sums_of_motion();
  std::set<std::uint32_t> walls;
  double pushing = 0.;
  for (std::size_t row = 0; row < rows.size(); ++row)
    pushing += carries_force(row);
  for (std::size_t row = pair_of_row.size(); row < rows.size(); ++row)
    walls.insert(rows.b[row]);
  std::vector<double> here = {deepest, static_cast<double>(list.n_pairs()), static_cast<double>(rows.size()),
                              pushing, static_cast<double>(walls.size())};
  for (const ExactSum &sum : sums)
    sum.pack(here);
  sums.assign(sums.size(), ExactSum());
  totals = DynamicsSums();
  exchanges.n_walls = 0;
  for (const std::vector<double> &other : share->exchange.of_all(here))
  {
    deepest = std::max(deepest, other[0]);
    totals.n_pairs += static_cast<std::size_t>(other[1]);
    totals.n_contacts += static_cast<std::size_t>(other[2]);
    totals.n_pushing += static_cast<std::size_t>(other[3]);
    exchanges.n_walls +=
        static_cast<unsigned int>(other[4]); // those of the first owner, for others have none
    const double *number = &other[5];
    for (ExactSum &sum : sums)
      sum.add_packed(number);
  }
  totals.kinetic = sums[0].value();
  totals.moving = sums[1].value();
  totals.momentum = dealii::Tensor<1, 2>({sums[2].value(), sums[3].value()});
}
struct Dynamics::Work
{
  ExactSum loss, force, impulse[2];
  std::vector<ExactSum> load;
};

void Dynamics::add_work(const std::size_t i,
                        const double dt,
                        const std::vector<std::array<double, 2>> &acceleration,
                        const std::vector<std::vector<std::array<double, 2>>> &of_loads,
                        Work &work) const
{
  const bool pulled = !acceleration.empty();
  double kinetic_loss = 0., attraction = 0., force_work = 0.;
  for (unsigned int d = 0; d < 2; ++d)
  {
    const double before = primaries.velocity[i][d], after = bodies.velocity[i][d];
    kinetic_loss += 0.5 * primaries.mass[i] * (before - after) * (before + after);
    attraction += dt * force[i][d] * 0.5 * (before + after);
    if (!pulled)
      continue;
    const double impulse = dt * primaries.mass[i] * acceleration[i][d];
    force_work += impulse * 0.5 * (before + after);
    work.impulse[d].add(impulse);
  }
  if (rotations)
  {
    const double before = primaries.angular_velocity[i], after = bodies.angular_velocity[i];
    kinetic_loss += 0.25 * primaries.mass[i] * primaries.radius[i] * primaries.radius[i] * (before - after) *
                    (before + after);
  }
  work.loss.add(kinetic_loss + attraction + force_work);
  if (!pulled)
    return;
  work.force.add(force_work);
  for (std::size_t load = 0; load < of_loads.size(); ++load)
  {
    const std::array<double, 2> &pull = of_loads[load][i];
    double sum = 0.;
    for (unsigned int d = 0; d < 2; ++d)
      sum += dt * primaries.mass[i] * pull[d] * 0.5 * (primaries.velocity[i][d] + bodies.velocity[i][d]);
    work.load[load].add(sum);
  }
}

void Dynamics::account(const double dt,
                       const std::vector<std::array<double, 2>> &acceleration,
                       const std::vector<std::vector<std::array<double, 2>>> &of_loads,
                       DynamicsReport &report) const
{
  // Work is impulse times the mean of the velocities before and after, so that the books balance to rounding
  // but for the work of the attraction, which is compared with its potential.
  const std::size_t n_loads = of_loads.size(), n = n_own();
  std::vector<Work> of_piece(n / grain + 1);
  parallel_for(n, grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 Work &work = of_piece[begin / grain];
                 work.load.resize(n_loads);
                 for (std::size_t i = begin; i < end; ++i)
                   if (inverse_mass[i] != 0.)
                     add_work(i, dt, acceleration, of_loads, work);
               });
  std::vector<ExactSum> all(4 + n_loads);
  for (const Work &work : of_piece)
  {
    all[0].add(work.loss);
    if (acceleration.empty())
      continue;
    all[1].add(work.force);
    all[2].add(work.impulse[0]);
    all[3].add(work.impulse[1]);
    for (std::size_t load = 0; load < work.load.size(); ++load)
      all[4 + load].add(work.load[load]);
  }
  if (share)
    add_over_all(all, share->exchange);
  report.contact_loss += all[0].value();
  report.loads.work += all[1].value();
  for (std::size_t load = 0; load < n_loads; ++load)
    report.loads.of_loads.push_back(all[4 + load].value());
  report.loads.impulse = dealii::Tensor<1, 2>({all[2].value(), all[3].value()});
}
} // namespace softgrain::bpm
