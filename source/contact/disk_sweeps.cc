// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/disk_sweeps.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::contact
{
namespace
{
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Contacts that one thread sweeps at least before it takes the next piece; taking one costs some 0.1 µs.
constexpr std::uint32_t rows_per_range = 400;

/// Bodies that one thread extrapolates before it takes the next piece.
constexpr std::uint32_t bodies_per_piece = 2048;

/// Parts of a range that take turns.
constexpr std::uint32_t n_lanes = 4;
} // namespace

template <unsigned int n, bool in_cell>
DiskSweeps<n, in_cell>::DiskSweeps(const DiskBodies &bodies, const DiskContacts &contacts, ThreadTeam &team)
    : bodies(bodies), contacts(contacts), team(team), rows(new Row[contacts.size()])
{
  number_bodies();
  make_ranges();
  for_ranges_at_once([&](const Range range, const bool wall, std::uint32_t) { pack(range, wall); });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::number_bodies()
{
  packed_of.assign(bodies.size(), none);
  original_of.reserve(bodies.size());
  const auto meet = [&](const std::uint32_t body)
  {
    if (packed_of[body] == none)
    {
      packed_of[body] = original_of.size();
      original_of.push_back(body);
    }
  };
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    meet(contacts.a[i]);
    meet(contacts.b[i]);
  }
  states.reset(new State[n_bodies()]);
  last_velocity.reset(new std::array<double, n_velocities>[n_bodies()]);
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::make_ranges()
{
  const auto &tiles = contacts.tile_start;
  for (std::size_t colour = 0; colour + 1 < contacts.colour_start.size(); ++colour)
  {
    const std::uint32_t end = contacts.colour_start[colour + 1];
    for (std::uint32_t tile = contacts.colour_start[colour]; tile < end;)
    {
      Range range{tiles[tile], tiles[tile + 1]};
      while (++tile < end && range.last - range.first < rows_per_range)
        range.last = tiles[tile + 1];
      if (range.last > range.first)
        ranges.push_back(range);
    }
    colour_end.push_back(ranges.size());
  }
  ranges.push_back({tiles.back(), std::uint32_t(contacts.size())});
  sums.resize(ranges.size());
  approach.resize(ranges.size());

  // Walls are numbered as they appear; there are few.
  std::vector<std::uint32_t> walls;
  wall_of.resize(ranges.back().last - ranges.back().first);
  interleave(ranges.back(),
             [&](const std::uint32_t row, const std::uint32_t contact)
             {
               const auto found = std::find(walls.begin(), walls.end(), contacts.b[contact]);
               wall_of[row - ranges.back().first] = found - walls.begin();
               if (found == walls.end())
                 walls.push_back(contacts.b[contact]);
             });
  n_walls = walls.size();
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::interleave(const Range range, const Work &work)
{
  const std::uint32_t length = (range.last - range.first + n_lanes - 1) / n_lanes;
  std::uint32_t row = range.first;
  for (std::uint32_t i = 0; i < length; ++i)
    for (std::uint32_t contact = range.first + i; contact < range.last; contact += length)
      work(row++, contact);
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::for_ranges(const Work &work)
{
  if (in_cell && cell.is_free())
  {
    for (std::uint32_t i = 0; i < ranges.size(); ++i)
      work(ranges[i], i + 1 == ranges.size(), i);
    return;
  }
  std::uint32_t first = 0;
  for (const std::uint32_t end : colour_end)
  {
    team.run(end - first, [&](const std::uint32_t i) { work(ranges[first + i], false, first + i); });
    first = end;
  }
  work(ranges.back(), true, ranges.size() - 1);
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::for_ranges_at_once(const Work &work)
{
  team.run(ranges.size(), [&](const std::uint32_t i) { work(ranges[i], i + 1 == ranges.size(), i); });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::pack(const Range range, const bool wall)
{
  interleave(
      range,
      [&](const std::uint32_t packed, const std::uint32_t i)
      {
        Row &row = rows[packed];
        row.a = packed_of[contacts.a[i]];
        row.b = packed_of[contacts.b[i]];
        row.normal[0] = contacts.normal[i][0];
        row.normal[1] = contacts.normal[i][1];
        row.gap_velocity = contacts.gap_velocity[i];
        row.impulse[0] = contacts.impulse[i];
        if constexpr (n > 1)
        {
          row.friction = contacts.friction[i];
          row.arm_a = contacts.arm_a[i];
          row.arm_b = !wall ? contacts.arm_b[i] : contacts.wall_slip.empty() ? 0. : contacts.wall_slip[i];
          row.impulse[1] = contacts.tangential_impulse[i];
        }
        if constexpr (n > 2)
        {
          row.rolling = contacts.rolling[i];
          row.impulse[2] = contacts.rolling_impulse[i];
        }
        if constexpr (in_cell)
          std::copy_n(contacts.branch[i].begin(), 2, row.branch);
        // A start that is no impulse at all, or one between prescribed bodies, would stay.
        using Contact = DiskContact<n, false>;
        if (bodies.inverse_mass[contacts.a[i]] + bodies.inverse_mass[contacts.b[i]] == 0.)
          std::fill(row.impulse, row.impulse + n, 0.);
        Contact::project(row, row.impulse);
        std::copy(row.impulse, row.impulse + n, row.previous);
      });
}

template <unsigned int n, bool in_cell>
template <class Work>
void DiskSweeps<n, in_cell>::for_bodies(const Work &work)
{
  const std::uint32_t n_pieces = (n_bodies() + bodies_per_piece - 1) / bodies_per_piece;
  team.run(n_pieces,
           [&](const std::uint32_t piece)
           {
             const std::size_t end = std::min<std::size_t>(n_bodies(), (piece + 1) * bodies_per_piece);
             for (std::size_t i = piece * bodies_per_piece; i < end; ++i)
               work(i);
           });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::set_free_velocities()
{
  cell = bodies.cell;
  last_cell = DiskCell();
  for_bodies(
      [&](const std::size_t i)
      {
        const std::uint32_t body = original_of[i];
        State &state = states[i];
        state.velocity[0] = bodies.velocity[body][0];
        state.velocity[1] = bodies.velocity[body][1];
        state.inverse_mass = bodies.inverse_mass[body];
        if constexpr (n > 1)
        {
          state.angular_velocity = bodies.angular_velocity[body];
          state.inverse_inertia = bodies.inverse_inertia[body];
        }
        last_velocity[i].fill(0.);
      });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::apply_impulses()
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
          add(DiskContact<n, true>());
        else
          add(DiskContact<n, false>());
      });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::clear_impulses()
{
  for (std::size_t i = 0; i < contacts.size(); ++i)
    std::fill(rows[i].impulse, rows[i].impulse + n, 0.);
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::sweep(const double relaxation)
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
          sweep_range(DiskContact<n, true>());
        else
          sweep_range(DiskContact<n, false>());
      });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::add_cell(const Row &row, double (&w)[n], DiskCompliance<n> &W) const
{
  if constexpr (in_cell)
  {
    DiskCellContact<n>::add_velocity(row, cell, w);
    DiskCellContact<n>::add_compliance(row, cell, W);
  }
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::move_cell(const Row &row, const double (&change)[n])
{
  if constexpr (in_cell)
    if (cell.is_free())
      DiskCellContact<n>::apply(row, cell, change);
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::extrapolate(const double momentum)
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
        step(states[i].velocity[0], last_velocity[i][0]);
        step(states[i].velocity[1], last_velocity[i][1]);
        if constexpr (n > 1)
          step(states[i].angular_velocity, last_velocity[i][2]);
      });
}

template <unsigned int n, bool in_cell>
double DiskSweeps<n, in_cell>::sweep_with_momentum(const double momentum)
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
            sum -= W.normal * change[0] * (P[0] - row.previous[0]);
            if constexpr (n > 1)
              sum -= W.tangential * change[1] * (P[1] - row.previous[1]);
            if constexpr (n > 2)
              sum -= W.rolling * change[2] * (P[2] - row.previous[2]);
          }
          sums[index] = sum;
        };
        if (wall)
          sweep_range(DiskContact<n, true>());
        else
          sweep_range(DiskContact<n, false>());
      });
  double sum = 0.;
  for (const double part : sums)
    sum += part;
  return sum;
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::save_impulses()
{
  saved.resize(contacts.size());
  for_ranges_at_once(
      [&](const Range range, bool, std::uint32_t)
      {
        for (std::uint32_t i = range.first; i < range.last; ++i)
          std::copy(rows[i].impulse, rows[i].impulse + n, saved[i].begin());
      });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::restore_impulses()
{
  for (std::size_t i = 0; i < saved.size(); ++i)
    std::copy(saved[i].begin(), saved[i].end(), rows[i].impulse);
}

template <unsigned int n, bool in_cell>
typename DiskSweeps<n, in_cell>::Measure DiskSweeps<n, in_cell>::measure()
{
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
          measure_range(DiskContact<n, true>());
        else
          measure_range(DiskContact<n, false>());
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
  return result;
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::wall_impulses(std::vector<double> &wall_sums) const
{
  wall_sums.assign(n_walls, 0.);
  const Range range = ranges.back();
  for (std::uint32_t i = range.first; i < range.last; ++i)
    wall_sums[wall_of[i - range.first]] += rows[i].impulse[0];
  if constexpr (in_cell)
    if (cell.is_free() && contacts.size() > 0)
    {
      double sum[2] = {0., 0.}, branches = 0.;
      for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        branches += std::sqrt(rows[i].branch[0] * rows[i].branch[0] + rows[i].branch[1] * rows[i].branch[1]);
        for (unsigned int d = 0; d < 2; ++d)
          sum[d] += rows[i].impulse[0] * rows[i].normal[d] * rows[i].branch[d];
      }
      for (const double one : sum)
        wall_sums.push_back(branches > 0. ? one / branches * contacts.size() : 0.);
    }
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::store_impulses(DiskContacts &target)
{
  for_ranges_at_once(
      [&](const Range range, bool, std::uint32_t)
      {
        interleave(range,
                   [&](const std::uint32_t row, const std::uint32_t i)
                   {
                     target.impulse[i] = rows[row].impulse[0];
                     if constexpr (n > 1)
                       target.tangential_impulse[i] = rows[row].impulse[1];
                     if constexpr (n > 2)
                       target.rolling_impulse[i] = rows[row].impulse[2];
                   });
      });
}

template <unsigned int n, bool in_cell>
void DiskSweeps<n, in_cell>::store_velocities(DiskBodies &target) const
{
  target.cell = cell;
  for (std::size_t i = 0; i < n_bodies(); ++i)
  {
    const std::uint32_t body = original_of[i];
    target.velocity[body] = {{states[i].velocity[0], states[i].velocity[1]}};
    if constexpr (n > 1)
      target.angular_velocity[body] = states[i].angular_velocity;
  }
}

template class DiskSweeps<1>;
template class DiskSweeps<2>;
template class DiskSweeps<3>;
template class DiskSweeps<1, true>;
template class DiskSweeps<2, true>;
template class DiskSweeps<3, true>;
} // namespace softgrain::contact
