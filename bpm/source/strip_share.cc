// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/strip_share.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace softgrain::bpm
{
namespace
{
using Indices = std::vector<std::uint32_t>;

constexpr unsigned int n_numbers(const std::vector<double> *)
{
  return 1;
}
constexpr unsigned int n_numbers(const std::vector<std::array<double, 2>> *)
{
  return 2;
}
double *numbers_at(double &value)
{
  return &value;
}
double *numbers_at(std::array<double, 2> &value)
{
  return value.data();
}

/// Two indices as one number, that is only copied.
double packed(const std::uint32_t a, const std::uint32_t b)
{
  const std::uint32_t both[2] = {a, b};
  double number;
  std::memcpy(&number, both, sizeof number);
  return number;
}

std::array<std::uint32_t, 2> unpacked(const double number)
{
  std::array<std::uint32_t, 2> both;
  std::memcpy(both.data(), &number, sizeof number);
  return both;
}

/// Primaries on their way to other ranks: who goes where, and in what order those that come are kept.
class Journey
{
public:
  Journey(const Exchange &exchange, std::vector<Indices> leaving, const Indices &numbers)
      : exchange(exchange), leaving(std::move(leaving))
  {
    std::vector<std::vector<double>> lists(exchange.number());
    for (unsigned int r = 0; r < exchange.number(); ++r)
      for (const std::uint32_t i : this->leaving[r])
        lists[r].push_back(numbers[i]);
    for (const std::vector<double> &came : exchange.to_each(std::move(lists)))
      arrived.insert(arrived.end(), came.begin(), came.end());
    order.resize(arrived.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [this](const std::uint32_t a, const std::uint32_t b) { return arrived[a] < arrived[b]; });
  }

  /// Numbers of those that have come.
  std::size_t size() const { return arrived.size(); }
  void append_numbers(Indices &numbers) const
  {
    for (const std::uint32_t k : order)
      numbers.push_back(arrived[k]);
  }

  /// Adds what those that come bring of @p values to @p target.
  template <class T>
  void carry(std::vector<T> &values, std::vector<T> &target) const
  {
    constexpr unsigned int n = n_numbers(static_cast<std::vector<T> *>(nullptr));
    std::vector<std::vector<double>> lists(exchange.number());
    for (unsigned int r = 0; r < exchange.number(); ++r)
    {
      lists[r].reserve(n * leaving[r].size());
      for (const std::uint32_t i : leaving[r])
        lists[r].insert(lists[r].end(), numbers_at(values[i]), numbers_at(values[i]) + n);
    }
    const std::vector<std::vector<double>> came = exchange.to_each(std::move(lists));
    std::vector<T> unordered(order.size());
    std::size_t k = 0;
    for (const std::vector<double> &list : came)
      for (std::size_t i = 0; i < list.size(); i += n)
        std::copy_n(&list[i], n, numbers_at(unordered[k++]));
    for (const std::uint32_t i : order)
      target.push_back(unordered[i]);
  }

private:
  const Exchange &exchange;
  std::vector<Indices> leaving;
  Indices arrived, order;
};

template <class T>
void shorten(std::vector<T> &values, const std::size_t begin, const std::size_t end)
{
  if (!values.empty())
    values = std::vector<T>(values.begin() + begin, values.begin() + end);
}
} // namespace

void StripShare::cut(Primaries &disks)
{
  n_primaries = disks.size();
  has.spins = disks.rotate();
  has.strength = !disks.strength.empty();
  has.start = !disks.start.empty();
  const std::size_t begin = n_primaries * exchange.here() / exchange.number(),
                    end = n_primaries * (exchange.here() + 1) / exchange.number();
  shorten(disks.position, begin, end);
  shorten(disks.velocity, begin, end);
  shorten(disks.radius, begin, end);
  shorten(disks.mass, begin, end);
  shorten(disks.body, begin, end);
  shorten(disks.angular_velocity, begin, end);
  shorten(disks.strength, begin, end);
  shorten(disks.start, begin, end);
  disks.number.resize(end - begin);
  std::iota(disks.number.begin(), disks.number.end(), begin);
  n_own_primaries = end - begin;
  n_seam = 0;
}

void StripShare::share_out(Primaries &disks, Motion &kept, contact::NeighbourList &list)
{
  choose_strips(disks, list.cell_size());
  const std::vector<std::vector<double>> came = send_memories(disks, list);
  carry(disks, kept);
  make_rounds(disks);
  const std::size_t first = first_strip(exchange.here());
  list.build_part({disks.position, disks.radius, disks.body}, n_own_primaries,
                  {grid, first, end_strip[exchange.here()]},
                  memories_of(came, disks.number, list.memory().n_impulses()));
}

void StripShare::choose_strips(const Primaries &disks, const double cell)
{
  contact::NeighbourList::Bounds bounds;
  exchange.together([&]() { bounds.take(disks.position, n_own_primaries); });
  for (const std::vector<double> &other :
       exchange.of_all({bounds.lower[0], bounds.lower[1], bounds.upper[0], bounds.upper[1]}))
    for (unsigned int d = 0; d < 2; ++d)
    {
      bounds.lower[d] = std::min(bounds.lower[d], other[d]);
      bounds.upper[d] = std::max(bounds.upper[d], other[2 + d]);
    }
  grid = contact::StripGrid(bounds.lower, bounds.upper, n_primaries, cell,
                            contact::is_sparse(bounds.lower, bounds.upper, n_primaries, cell)
                                ? spans_of_all(disks, cell)
                                : std::vector<contact::StripGrid::Span>());
  std::vector<double> here(grid.n_strips(), 0.), all(grid.n_strips(), 0.);
  for (std::size_t i = 0; i < n_own_primaries; ++i)
    here[grid.strip(disks.position[i])] += 1.;
  for (const std::vector<double> &other : exchange.of_all(here))
    for (std::size_t strip = 0; strip < all.size(); ++strip)
      all[strip] += other[strip];
  divide(all);
}

std::vector<contact::StripGrid::Span> StripShare::spans_of_all(const Primaries &disks,
                                                               const double cell) const
{
  std::vector<double> here;
  for (const contact::StripGrid::Span &span : contact::spans_of(disks.position, n_own_primaries, cell))
    here.insert(here.end(), span.begin(), span.end());
  std::vector<contact::StripGrid::Span> spans;
  for (const std::vector<double> &other : exchange.lists_of_all(here))
    for (std::size_t k = 0; k + 1 < other.size(); k += 2)
      spans.push_back({{other[k], other[k + 1]}});
  return contact::joined(std::move(spans), cell);
}

void StripShare::divide(const std::vector<double> &weight)
{
  const unsigned int n = exchange.number();
  const double all = std::accumulate(weight.begin(), weight.end(), 0.);
  double before = 0.;
  std::size_t strip = 0;
  end_strip.assign(n, weight.size());
  for (unsigned int r = 0; r + 1 < n; ++r)
  {
    // A strip belongs to the rank in whose part its middle lies.
    for (; strip < weight.size() && (before + 0.5 * weight[strip]) * n < (r + 1) * all; ++strip)
      before += weight[strip];
    end_strip[r] = strip;
  }
  tile_end.assign(2, std::vector<std::uint32_t>(n));
  // Tiles of even strips come first.
  for (unsigned int r = 0; r < n; ++r)
  {
    tile_end[0][r] = (end_strip[r] + 1) / 2;
    tile_end[1][r] = (weight.size() + 1) / 2 + end_strip[r] / 2;
  }
}

std::pair<std::uint32_t, std::uint32_t> tiles_of(const std::vector<std::vector<std::uint32_t>> &end_of_tiles,
                                                 const unsigned int colour,
                                                 const unsigned int owner)
{
  const std::uint32_t begin = owner > 0    ? end_of_tiles[colour][owner - 1]
                              : colour > 0 ? end_of_tiles[colour - 1].back()
                                           : 0;
  return {begin, end_of_tiles[colour][owner]};
}

unsigned int StripShare::owner(const std::size_t strip) const
{
  return std::upper_bound(end_strip.begin(), end_strip.end(), strip) - end_strip.begin();
}

unsigned int StripShare::before(const unsigned int rank) const
{
  return first_strip(rank) > 0 ? owner(first_strip(rank) - 1) : none;
}

unsigned int StripShare::after(const unsigned int rank) const
{
  return end_strip[rank] < grid.n_strips() ? owner(end_strip[rank]) : none;
}

std::vector<std::vector<double>> StripShare::send_memories(const Primaries &disks,
                                                           const contact::NeighbourList &list) const
{
  std::vector<std::vector<double>> lists(exchange.number());
  const contact::PairMemory &memory = list.memory();
  for (std::size_t pair = 0; pair < list.n_pairs(); ++pair)
    if (memory.remembers(pair))
    {
      // A pair belongs to the strip that comes first.
      const std::uint32_t a = list.a(pair), b = list.b(pair);
      std::vector<double> &to =
          lists[owner(std::min(grid.strip(disks.position[a]), grid.strip(disks.position[b])))];
      const contact::PairMemory::Impulses impulses = memory[pair];
      to.push_back(packed(disks.number[a], disks.number[b]));
      to.insert(to.end(), impulses.begin(), impulses.begin() + memory.n_impulses());
    }
  return exchange.to_each(std::move(lists));
}

contact::NeighbourList::Remembered StripShare::memories_of(const std::vector<std::vector<double>> &came,
                                                           const std::vector<std::uint32_t> &numbers,
                                                           const unsigned int n_impulses) const
{
  contact::NeighbourList::Remembered old;
  old.memories = contact::PairMemory(n_impulses);
  std::vector<double> &values = old.memories.values();
  for (const std::vector<double> &list : came)
    for (std::size_t k = 0; k < list.size(); k += 1 + n_impulses)
    {
      const auto [a, b] = unpacked(list[k]);
      const std::uint32_t first = place_of(a, numbers), second = place_of(b, numbers);
      if (first == none || second == none) // too far from each other now
        continue;
      old.first.push_back(first);
      old.second.push_back(second);
      values.insert(values.end(), &list[k] + 1, &list[k] + 1 + n_impulses);
    }
  return old;
}

void StripShare::carry(Primaries &disks, Motion &kept)
{
  std::vector<Indices> to_own(exchange.number()), to_seam(exchange.number());
  for (std::uint32_t i = 0; i < n_own_primaries; ++i)
  {
    const std::size_t column = grid.column(disks.position[i]), strip = column / grid.width;
    const unsigned int rank = owner(strip);
    to_own[rank].push_back(i);
    if (column == first_strip(rank) * grid.width && before(rank) != none)
      to_seam[before(rank)].push_back(i);
  }
  const Journey own(exchange, std::move(to_own), disks.number),
      seam(exchange, std::move(to_seam), disks.number);
  const auto go = [&](auto &values)
  {
    std::decay_t<decltype(values)> there;
    there.reserve(own.size() + seam.size());
    own.carry(values, there);
    seam.carry(values, there);
    values.swap(there);
  };
  std::vector<double> body(disks.body.begin(), disks.body.end());
  go(body);
  disks.body.assign(body.begin(), body.end());
  const bool keeps = exchange.any(!kept.position.empty());
  go(disks.position);
  go(disks.velocity);
  go(disks.radius);
  go(disks.mass);
  if (has.spins)
    go(disks.angular_velocity);
  if (has.strength)
    go(disks.strength);
  if (has.start)
    go(disks.start);
  if (keeps)
  {
    go(kept.position);
    go(kept.velocity);
    if (has.spins)
      go(kept.angular_velocity);
  }
  disks.number.clear();
  own.append_numbers(disks.number);
  seam.append_numbers(disks.number);
  n_own_primaries = own.size();
  n_seam = seam.size();
  n_own_of.clear();
  for (const std::vector<double> &one : exchange.of_all({static_cast<double>(n_own_primaries)}))
    n_own_of.push_back(static_cast<std::size_t>(one[0]));
}

void StripShare::make_rounds(const Primaries &disks)
{
  rounds = {};
  to_previous.clear();
  const unsigned int here = exchange.here();
  if (!has_strips(here))
    return;
  const std::size_t first = first_strip(here), last = end_strip[here] - 1;
  // Of the two tiles at a seam, that of this colour has just told its primaries something.
  const auto add = [&](const unsigned int other, const std::size_t strip, const Indices &bodies)
  {
    for (unsigned int colour = 0; colour < 2; ++colour)
      (strip % 2 == colour ? rounds[colour].send : rounds[colour].receive).push_back({other, bodies, {}});
  };
  if (before(here) != none)
  {
    for (std::uint32_t i = 0; i < n_own_primaries; ++i)
      if (grid.column(disks.position[i]) == first * grid.width)
        to_previous.push_back(i);
    add(before(here), first, to_previous);
  }
  if (after(here) != none)
  {
    Indices seam(n_seam);
    std::iota(seam.begin(), seam.end(), n_own_primaries);
    add(after(here), last, seam);
  }
}

bool StripShare::is_at_seam(const std::uint32_t i) const
{
  return std::binary_search(to_previous.begin(), to_previous.end(), i);
}

std::uint32_t StripShare::place_of(const std::uint32_t number,
                                   const std::vector<std::uint32_t> &numbers) const
{
  const auto own_end = numbers.begin() + n_own_primaries, seam_end = own_end + n_seam;
  for (const auto &[begin, end] :
       {std::make_pair(numbers.begin(), own_end), std::make_pair(own_end, seam_end)})
  {
    const auto found = std::lower_bound(begin, end, number);
    if (found != end && *found == number)
      return found - numbers.begin();
  }
  return none;
}

std::vector<double>
StripShare::at_first(const double *const values, const unsigned int n, const Primaries &disks) const
{
  // One rank after the other, so that the first one holds little more than the result.
  if (!exchange.first())
  {
    std::vector<double> numbers(disks.number.begin(), disks.number.begin() + n_own_primaries),
        own(values, values + n * n_own_primaries);
    for (std::vector<double> *const list : {&numbers, &own})
      if (!list->empty())
        exchange.swap({{0, list->data(), list->size()}}, {});
    return {};
  }
  std::vector<double> all(n * n_primaries);
  for (std::size_t i = 0; i < n_own_primaries; ++i)
    std::copy_n(values + n * i, n, &all[static_cast<std::size_t>(n) * disks.number[i]]);
  for (unsigned int r = 1; r < exchange.number(); ++r)
  {
    std::vector<double> numbers(n_own_of[r]), came(n * numbers.size());
    for (std::vector<double> *const list : {&numbers, &came})
      if (!list->empty())
        exchange.swap({}, {{r, list->data(), list->size()}});
    for (std::size_t i = 0; i < numbers.size(); ++i)
      std::copy_n(&came[n * i], n, &all[n * static_cast<std::size_t>(numbers[i])]);
  }
  return all;
}
} // namespace softgrain::bpm
