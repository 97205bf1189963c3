// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of NeighbourList that asks whether the list must be made anew.
#include <softgrain/contact/neighbour_list.h>

#include <algorithm>
#include <cmath>

namespace softgrain::contact
{
namespace
{
constexpr double far = NeighbourList::Bounds::far;

/// Disks or groups beyond which a new list costs less than looking where each of them is.
constexpr std::size_t most_movers = 8;

/// Numbers that tell of one mover.
constexpr std::size_t n_numbers = 9;
} // namespace

/// A disk, or a group of disks, of which one at least has moved out of its skin.
struct NeighbourList::Mover
{
  std::uint32_t name = 0;
  double reference = far;      ///< lowest number of a disk of it, whose way stands for that of all
  std::array<double, 2> way{}; ///< of this disk since the list was made [m]
  Bounds box;                  ///< of the centres of its disks now [m]
  double radius = 0.;          ///< of its largest disk [m]
  bool has_neighbours = false; ///< whether the list has pairs of it with others

  void append_to(std::vector<double> &numbers) const
  {
    numbers.insert(numbers.end(), {reference, way[0], way[1], box.lower[0], box.lower[1], box.upper[0],
                                   box.upper[1], radius, has_neighbours ? 1. : 0.});
  }

  /// What another owner has of it too.
  void join(const double *const other)
  {
    if (other[0] < reference)
    {
      reference = other[0];
      way = {{other[1], other[2]}};
    }
    for (unsigned int d = 0; d < 2; ++d)
    {
      box.lower[d] = std::min(box.lower[d], other[3 + d]);
      box.upper[d] = std::max(box.upper[d], other[5 + d]);
    }
    radius = std::max(radius, other[7]);
    has_neighbours = has_neighbours || other[8] != 0.;
  }
};

/// How disks have moved since the list was made, beside what moves as the lattice deforms.
struct NeighbourList::Moves
{
  Moves(const NeighbourList &list,
        const std::vector<std::array<double, 2>> &places,
        const ImageLattice &now,
        const std::vector<std::uint32_t> &numbers)
      : places(places), list(list), now(now), then(list.built.lattice), numbers(numbers)
  {
    double strain = 0.;
    if (now.repeats())
    {
      for (unsigned int d = 0; d < 2; ++d)
        if (now.periodic[d])
          stretch[d] = now.length[d] / then.length[d];
      shear = (now.offset - stretch[0] * then.offset) / then.length[1];
      strain = std::sqrt((stretch[0] - 1.) * (stretch[0] - 1.) + (stretch[1] - 1.) * (stretch[1] - 1.) +
                         shear * shear);
    }
    room = 0.5 * (list.range.skin - strain * list.largest_distance);
  }

  std::array<double, 2> way(const std::size_t i) const
  {
    const std::array<double, 2> &start = list.built.positions[i];
    if (!now.repeats())
      return {{places[i][0] - start[0], places[i][1] - start[1]}};
    const double x = start[0] - then.lower[0], y = start[1] - then.lower[1];
    return {{places[i][0] - now.lower[0] - stretch[0] * x - shear * y,
             places[i][1] - now.lower[1] - stretch[1] * y}};
  }

  /// Whether a disk is still in its skin. A place that is no number is not.
  bool within(const std::array<double, 2> &way) const
  {
    return room > 0. && way[0] * way[0] + way[1] * way[1] < room * room;
  }

  std::uint32_t name(const std::size_t i) const
  {
    return !list.group.empty() ? list.group[i] : numbers.empty() ? i : numbers[i];
  }

  double number(const std::size_t i) const { return numbers.empty() ? i : numbers[i]; }

  /// Whether the box of @p mover, grown by @p reach, is smaller than the cell.
  bool fits(const Mover &mover, const double reach) const
  {
    for (unsigned int d = 0; d < 2; ++d)
      if (now.periodic[d] && !(mover.box.upper[d] - mover.box.lower[d] + 2. * reach < now.length[d]))
        return false;
    return true;
  }

  /// Whether a disk at @p x comes nearer than @p reach to the box of @p mover, or that cannot be told.
  bool meets(const Mover &mover, const std::array<double, 2> &x, const double reach) const
  {
    std::array<double, 2> middle, half;
    for (unsigned int d = 0; d < 2; ++d)
    {
      middle[d] = 0.5 * (mover.box.lower[d] + mover.box.upper[d]);
      half[d] = 0.5 * (mover.box.upper[d] - mover.box.lower[d]) + reach;
    }
    if (!fits(mover, reach))
      return true;
    const std::array<double, 2> d = between(middle, x);
    return !(std::abs(d[0]) > half[0] || std::abs(d[1]) > half[1]);
  }

  const std::vector<std::array<double, 2>> &places;
  double room = 0.; ///< to move in the skin [m]

private:
  /// Shortest way from @p from to an image of @p to, where it is less than half of the cell.
  std::array<double, 2> between(const std::array<double, 2> &from, const std::array<double, 2> &to) const
  {
    std::array<double, 2> d = {{to[0] - from[0], to[1] - from[1]}};
    if (now.periodic[1])
    {
      const double turns = std::round(d[1] / now.length[1]);
      d[1] -= turns * now.length[1];
      if (now.periodic[0])
        d[0] -= turns * now.offset;
    }
    if (now.periodic[0])
      d[0] -= std::round(d[0] / now.length[0]) * now.length[0];
    return d;
  }

  const NeighbourList &list;
  const ImageLattice &now, &then;
  const std::vector<std::uint32_t> &numbers;
  double stretch[2] = {1., 1.};
  double shear = 0.;
};

bool NeighbourList::is_outdated(const std::vector<std::array<double, 2>> &positions,
                                const ImageLattice &lattice,
                                const std::vector<std::uint32_t> &numbers,
                                const Tell &tell)
{
  if (built.lattice.periodic != lattice.periodic)
    return true;
  const Moves moves(*this, positions, lattice, numbers);
  std::vector<double> names;
  bool many = !(moves.room > 0.);
  for (std::size_t i = 0; i < built.positions.size() && !many; ++i)
  {
    const std::array<double, 2> way = moves.way(i);
    if (moves.within(way))
      continue;
    const double name = moves.name(i);
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
    many = names.size() > most_movers || !std::isfinite(way[0]) || !std::isfinite(way[1]);
  }
  // One message of fixed length, as most often there is nothing to tell.
  names.resize(most_movers, -1.);
  names.push_back(many ? 1. : 0.);
  std::vector<Mover> movers;
  for (std::vector<double> other : tell(names))
  {
    if (other.back() != 0.)
      return true;
    for (std::size_t k = 0; k < most_movers && other[k] >= 0.; ++k)
    {
      const std::uint32_t name = static_cast<std::uint32_t>(other[k]);
      if (std::none_of(movers.begin(), movers.end(), [&](const Mover &m) { return m.name == name; }))
      {
        movers.emplace_back();
        movers.back().name = name;
      }
    }
  }
  if (movers.empty())
    return false;
  if (movers.size() > most_movers)
    return true;
  return come_near(moves, movers, tell);
}

namespace
{
/// Whether a mover has a neighbour, meets itself across the cell, or may meet another one.
template <class Moves, class Mover>
bool meet_each_other(const Moves &moves, const std::vector<Mover> &movers, const double gap)
{
  for (std::size_t m = 0; m < movers.size(); ++m)
  {
    if (movers[m].has_neighbours || !moves.fits(movers[m], 2. * movers[m].radius + gap))
      return true;
    for (std::size_t other = 0; other < m; ++other)
    {
      // The other as a disk around its box.
      const auto &box = movers[other].box;
      const std::array<double, 2> middle = {
          {0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])}};
      if (moves.meets(movers[m], middle,
                      movers[m].radius + movers[other].radius + gap +
                          0.5 * std::hypot(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1])))
        return true;
    }
  }
  return false;
}
} // namespace

bool NeighbourList::come_near(const Moves &moves, std::vector<Mover> &movers, const Tell &tell)
{
  // By the number of the disk: which mover it belongs to, or none.
  const auto mover_of = [&](const std::size_t i) -> Mover *
  {
    const std::uint32_t name = moves.name(i);
    for (Mover &mover : movers)
      if (mover.name == name)
        return &mover;
    return nullptr;
  };
  mark_partners();
  for (std::size_t i = 0; i < radius.size(); ++i)
    if (Mover *const mover = mover_of(i))
    {
      mover->has_neighbours = mover->has_neighbours || has_partner[i] != 0;
      if (i >= built.positions.size())
        continue;
      if (moves.number(i) < mover->reference)
      {
        mover->reference = moves.number(i);
        mover->way = moves.way(i);
      }
      for (unsigned int d = 0; d < 2; ++d)
      {
        mover->box.lower[d] = std::min(mover->box.lower[d], moves.places[i][d]);
        mover->box.upper[d] = std::max(mover->box.upper[d], moves.places[i][d]);
      }
      mover->radius = std::max(mover->radius, radius[i]);
    }
  std::vector<double> here;
  for (const Mover &mover : movers)
    mover.append_to(here);
  for (const std::vector<double> &other : tell(here))
    for (std::size_t m = 0; m < movers.size(); ++m)
      movers[m].join(&other[m * n_numbers]);

  bool near = meet_each_other(moves, movers, range.gap);
  for (std::size_t i = 0; i < built.positions.size() && !near; ++i)
    if (const Mover *const mover = mover_of(i))
    {
      const std::array<double, 2> way = moves.way(i);
      near = !moves.within({{way[0] - mover->way[0], way[1] - mover->way[1]}});
    }
    else
      for (const Mover &other : movers)
        near = near || moves.meets(other, moves.places[i], other.radius + radius[i] + range.gap);
  for (const std::vector<double> &other : tell({near ? 1. : 0.}))
    near = near || other[0] != 0.;
  return near;
}

void NeighbourList::mark_partners()
{
  if (!has_partner.empty())
    return;
  has_partner.assign(radius.size(), 0);
  for (std::size_t pair = 0; pair < first.size(); ++pair)
    if (group.empty() || group[first[pair]] != group[second[pair]])
      has_partner[first[pair]] = has_partner[second[pair]] = 1;
}
} // namespace softgrain::contact
