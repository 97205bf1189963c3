// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/disk_sweeps.h>
#include <softgrain/contact/disk_sweeps_loops.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::contact
{
template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::set_free_velocities()
{
  cell = bodies.cell;
  last_cell = DiskCell();
  for_bodies(
      [&](const std::size_t i)
      {
        const std::uint32_t body = original_of[i];
        State &state = states[i];
        std::copy_n(bodies.velocity[body].begin(), dim, state.velocity);
        state.inverse_mass = bodies.inverse_mass[body];
        if constexpr (n > 1)
        {
          state.angular_velocity = bodies.angular_velocity[body];
          state.inverse_inertia = bodies.inverse_inertia[body];
        }
        last_velocity[i].fill(0.);
      });
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::apply_impulses()
{
  for_ranges(
      [&](const Range range, const bool wall, std::uint32_t)
      {
        const auto add = [&](auto contact)
        {
          for (std::uint32_t i = range.first; i < range.last; ++i)
          {
            contact.apply(rows[i], states[rows[i].a], states[rows[i].b], rows[i].impulse);
            move_cell(rows[i], rows[i].impulse);
          }
        };
        if (wall)
          add(Contact<true>());
        else
          add(Contact<false>());
      });
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::clear_impulses()
{
  for (std::size_t i = 0; i < contacts.size(); ++i)
    std::fill(rows[i].impulse, rows[i].impulse + n, 0.);
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::sweep(const double relaxation)
{
  for_ranges(
      [&](const Range range, const bool wall, std::uint32_t)
      {
        const auto sweep_range = [&](auto contact)
        {
          for (std::uint32_t i = range.first; i < range.last; ++i)
          {
            Row &row = rows[i];
            State &a = states[row.a], &b = states[row.b];
            double w[n], y[n], P[n], change[n];
            contact.velocity(row, a, b, w);
            DiskCompliance<n> W = contact.compliance(row, a, b);
            add_cell(row, w, W);
            for (unsigned int c = 0; c < n; ++c)
              y[c] = row.impulse[c];
            contact.solve(row, W, w, y, P);
            if (relaxation != 1.)
            {
              for (unsigned int c = 0; c < n; ++c)
                P[c] = y[c] + relaxation * (P[c] - y[c]);
              contact.project(row, P);
            }
            for (unsigned int c = 0; c < n; ++c)
            {
              change[c] = P[c] - y[c];
              row.impulse[c] = P[c];
            }
            contact.apply(row, a, b, change);
            move_cell(row, change);
          }
        };
        if (wall)
          sweep_range(Contact<true>());
        else
          sweep_range(Contact<false>());
      });
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::add_cell(const Row &row, double (&w)[n], DiskCompliance<n> &W) const
{
  if constexpr (in_cell)
  {
    DiskCellContact<n>::add_velocity(row, cell, w);
    DiskCellContact<n>::add_compliance(row, cell, W);
  }
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::move_cell(const Row &row, const double (&change)[n])
{
  if constexpr (in_cell)
    if (cell.is_free())
      DiskCellContact<n>::apply(row, cell, change);
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::extrapolate(const double momentum)
{
  if (in_cell && cell.is_free())
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
        if (cell.inverse_mass[k][l] > 0.)
        {
          const double before = cell.gradient[k][l];
          cell.gradient[k][l] += momentum * (before - last_cell.gradient[k][l]);
          last_cell.gradient[k][l] = before;
        }
  for_bodies(
      [&](const std::size_t i)
      {
        const auto step = [&](double &now, double &last)
        {
          const double before = now;
          now += momentum * (now - last);
          last = before;
        };
        for (unsigned int c = 0; c < n_velocities; ++c)
          step(velocity(i, c), last_velocity[i][c]);
      });
}

template <unsigned int n, bool in_cell, int dim>
double DiskSweeps<n, in_cell, dim>::sweep_with_momentum(const double momentum)
{
  // Velocities are linear in the impulses, so those that belong to the extrapolated impulses are known. An
  // extrapolated impulse may pull; the contact's own solution puts that right.
  extrapolate(momentum);
  for_ranges(
      [&](const Range range, const bool wall, const std::uint32_t index)
      {
        const auto sweep_range = [&](auto contact)
        {
          double sum = 0.;
          for (std::uint32_t i = range.first; i < range.last; ++i)
          {
            Row &row = rows[i];
            State &a = states[row.a], &b = states[row.b];
            double w[n], y[n], P[n], change[n];
            contact.velocity(row, a, b, w);
            DiskCompliance<n> W = contact.compliance(row, a, b);
            add_cell(row, w, W);
            for (unsigned int c = 0; c < n; ++c)
              y[c] = row.impulse[c] + momentum * (row.impulse[c] - row.previous[c]);
            contact.solve(row, W, w, y, P);
            for (unsigned int c = 0; c < n; ++c)
            {
              change[c] = P[c] - y[c];
              row.previous[c] = row.impulse[c];
              row.impulse[c] = P[c];
            }
            contact.apply(row, a, b, change);
            move_cell(row, change);
            for (unsigned int c = 0; c < n; ++c)
              sum -= W.of(c) * change[c] * (P[c] - row.previous[c]);
          }
          sums[index] = sum;
        };
        if (wall)
          sweep_range(Contact<true>());
        else
          sweep_range(Contact<false>());
      });
  if (share && n > 1)
    return 0.;
  if (share)
    share->share_ranges(sums);
  double sum = 0.;
  for (const double part : sums)
    sum += part;
  return sum;
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::save_impulses()
{
  saved.resize(contacts.size());
  for_ranges_at_once(
      [&](const Range range, bool, std::uint32_t)
      {
        for (std::uint32_t i = range.first; i < range.last; ++i)
          std::copy(rows[i].impulse, rows[i].impulse + n, saved[i].begin());
      });
}

template <unsigned int n, bool in_cell, int dim>
void DiskSweeps<n, in_cell, dim>::restore_impulses()
{
  for (std::size_t i = 0; i < saved.size(); ++i)
    std::copy(saved[i].begin(), saved[i].end(), rows[i].impulse);
}

template <unsigned int n, bool in_cell, int dim>
typename DiskSweeps<n, in_cell, dim>::Measure DiskSweeps<n, in_cell, dim>::measure()
{
  if (share)
    for (std::vector<double> *const list : {&sums, &approach})
      std::fill(list->begin(), list->end(), 0.);
  for_ranges_at_once(
      [&](const Range range, const bool wall, const std::uint32_t index)
      {
        const auto measure_range = [&](auto contact)
        {
          double worst = 0., fastest = 0.;
          for (std::uint32_t i = range.first; i < range.last; ++i)
          {
            const Row &row = rows[i];
            const State &a = states[row.a], &b = states[row.b];
            double w[n];
            contact.velocity(row, a, b, w);
            DiskCompliance<n> W = contact.compliance(row, a, b);
            add_cell(row, w, W);
            const double here = contact.natural_map(row, W, w);
            worst = here <= worst ? worst : here; // takes what is not a number
            fastest = std::max(fastest, W.normal > 0. ? -w[0] : 0.);
          }
          sums[index] = worst;
          approach[index] = fastest;
        };
        if (wall)
          measure_range(Contact<true>());
        else
          measure_range(Contact<false>());
      });
  Measure result;
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    if (!(sums[i] <= result.natural_map))
      result.natural_map = sums[i];
    result.approach = std::max(result.approach, approach[i]);
    if (std::isnan(sums[i]))
      break;
  }
  if (share)
  {
    std::vector<double> found = {result.natural_map, result.approach};
    share->take_largest(found);
    result = {found[0], found[1]};
  }
  return result;
}

template class DiskSweeps<1>;
template class DiskSweeps<2>;
template class DiskSweeps<3>;
template class DiskSweeps<1, true>;
template class DiskSweeps<2, true>;
template class DiskSweeps<3, true>;
template class DiskSweeps<1, false, 3>;
template class DiskSweeps<4, false, 3>;
} // namespace softgrain::contact
