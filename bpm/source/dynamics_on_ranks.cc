// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that works with other ranks, each of which has some of the primaries.
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/strips_in_files.h>

#include <algorithm>
#include <map>
#include <utility>

namespace softgrain::bpm
{
namespace
{
constexpr unsigned int first_rank = 0;

/// Primaries of @p at_walls, each once, in order.
template <class List>
std::vector<std::uint32_t> primaries_of(const List &at_walls)
{
  std::vector<std::uint32_t> which;
  for (const auto &at : at_walls)
    which.push_back(at.primary);
  std::sort(which.begin(), which.end());
  which.erase(std::unique(which.begin(), which.end()), which.end());
  return which;
}
} // namespace

void Dynamics::share_by(const Exchange &everyone, const std::vector<Wall<2>> &walls)
{
  exchange = &everyone;
  const bool repeats = any_sides(walls);
  if (exchange->alone() || repeats || remembered.adhesion.acts() || obstacles != nullptr ||
      primaries.size() < fewest_to_part)
    return;
  share = std::make_unique<StripShare>(*exchange);
  share->cut(primaries);
  weigh();
}

void Dynamics::update_list()
{
  if (!share)
  {
    n_lists += list.update(primaries.position, lattice());
    return;
  }
  drop_guests();
  const auto tell = [&](const std::vector<double> &numbers) { return share->exchange.of_all(numbers); };
  if (n_lists > 0 && !list.is_outdated(primaries.position, {}, primaries.number, tell))
    return;
  share->share_out(primaries, kept, list);
  weigh();
  ++n_lists;
}

void Dynamics::drop_guests()
{
  const std::size_t n = share->n_held();
  primaries.position.resize(n);
  primaries.velocity.resize(n);
  primaries.radius.resize(n);
  primaries.mass.resize(n);
  primaries.body.resize(n);
  primaries.number.resize(n);
  inverse_mass.resize(n);
  if (rotations)
    primaries.angular_velocity.resize(n);
  if (share->carried().strength)
    primaries.strength.resize(n);
  if (share->carried().start)
    primaries.start.resize(n);
}

void Dynamics::take_back_motion(const std::vector<Wall<2>> &walls)
{
  primaries.position = kept.position;
  primaries.velocity = kept.velocity;
  primaries.angular_velocity = kept.angular_velocity;
  if (share)
    drop_guests();
  detect(walls);
}

void Dynamics::tell_forces(const unsigned int colour)
{
  contact::DiskRound round = share->seams(colour);
  round.exchange<2>(share->exchange,
                    [this](const std::uint32_t i, const unsigned int d) -> double & { return force[i][d]; });
}

void Dynamics::tell_energies()
{
  std::vector<Exchange::Piece> pieces;
  for (unsigned int colour = 0; colour < 2; ++colour)
    for (unsigned int r = 0; r < share->exchange.number(); ++r)
    {
      const auto [begin, end] = tiles_of(share->end_of_tiles(), colour, r);
      pieces.push_back({r, tile_energy.data() + begin, end - begin});
    }
  share->exchange.share(pieces);
}

std::vector<double> Dynamics::wall_list(const std::vector<AtWall> &at_walls,
                                        const std::vector<std::uint32_t> &of_them) const
{
  // What the first rank has to know of a primary at a wall, and then where it is near to one.
  std::vector<double> numbers = {static_cast<double>(of_them.size())};
  for (const std::uint32_t i : of_them)
  {
    numbers.insert(numbers.end(),
                   {static_cast<double>(primaries.number[i]), share->is_at_seam(i) ? 1. : 0.,
                    static_cast<double>(primaries.body[i]), primaries.position[i][0],
                    primaries.position[i][1], primaries.velocity[i][0], primaries.velocity[i][1],
                    primaries.radius[i], primaries.mass[i], force[i][0], force[i][1]});
    if (rotations)
      numbers.push_back(primaries.angular_velocity[i]);
    if (share->carried().start)
      numbers.insert(numbers.end(), {primaries.start[i][0], primaries.start[i][1]});
  }
  for (const AtWall &at : at_walls)
    numbers.insert(numbers.end(),
                   {static_cast<double>(at.wall), static_cast<double>(primaries.number[at.primary]), at.gap});
  return numbers;
}

void Dynamics::bring_wall_rows(const std::vector<Wall<2>> &walls)
{
  const Exchange &all = share->exchange;
  const std::vector<AtWall> here = find_at_walls(walls, 0, share->n_own());
  const std::vector<std::uint32_t> own = primaries_of(here),
                                   copies =
                                       primaries_of(find_at_walls(walls, share->n_own(), share->n_held()));
  const std::vector<std::vector<double>> lists = all.lists_at_first(wall_list(here, own));
  exchanges.rotate = rotations;
  exchanges.end_of_tiles = share->end_of_tiles();
  // Primaries at walls come to the first rank when all else has been swept, and go back to all that hold
  // them.
  contact::DiskRound to_first, from_first;
  if (!all.first())
  {
    if (!own.empty())
      to_first.send.push_back({first_rank, own, {}});
    std::vector<std::uint32_t> held = own;
    held.insert(held.end(), copies.begin(), copies.end());
    if (!held.empty())
      from_first.receive.push_back({first_rank, held, {}});
  }
  else
  {
    WallGuests guests;
    for (unsigned int r = 0; r < lists.size(); ++r)
      take_guests(r, lists[r], guests);
    std::sort(guests.at_walls.begin(), guests.at_walls.end(),
              [this](const AtWall &one, const AtWall &other)
              {
                return std::make_pair(one.wall, primaries.number[one.primary]) <
                       std::make_pair(other.wall, primaries.number[other.primary]);
              });
    for (unsigned int r = 1; r < lists.size(); ++r)
    {
      std::vector<std::uint32_t> &held = guests.own[r];
      if (!held.empty())
        to_first.receive.push_back({r, held, {}});
      held.insert(held.end(), guests.copies[r].begin(), guests.copies[r].end());
      if (!held.empty())
        from_first.send.push_back({r, held, {}});
    }
    add_wall_rows(walls, guests.at_walls);
  }
  exchanges.rounds = {{share->seams(0)}, {share->seams(1), to_first}, {from_first}};
}

void Dynamics::take_guests(const unsigned int owner, const std::vector<double> &list, WallGuests &guests)
{
  const double *number = list.data(), *const end = number + list.size();
  std::map<std::uint32_t, std::uint32_t> place;
  for (auto n = static_cast<std::size_t>(*number++); n > 0; --n)
  {
    const auto name = static_cast<std::uint32_t>(*number++);
    const bool at_seam = *number++ > 0.;
    std::uint32_t i = share->place_of(name, primaries.number);
    if (i == StripShare::none)
    {
      i = primaries.size();
      add_guest(name, number);
    }
    place[name] = i;
    number += numbers_of_guest();
    guests.own[owner].push_back(i);
    const unsigned int before = share->before(owner);
    if (at_seam)
      guests.copies[before].push_back(i);
  }
  for (; number < end; number += 3)
    guests.at_walls.push_back(
        {static_cast<std::uint32_t>(number[0]), place.at(static_cast<std::uint32_t>(number[1])), number[2]});
}

unsigned int Dynamics::numbers_of_guest() const
{
  return 9 + (rotations ? 1 : 0) + (share->carried().start ? 2 : 0);
}

void Dynamics::add_guest(const std::uint32_t name, const double *number)
{
  primaries.number.push_back(name);
  primaries.body.push_back(static_cast<std::uint32_t>(number[0]));
  primaries.position.push_back({number[1], number[2]});
  primaries.velocity.push_back({number[3], number[4]});
  primaries.radius.push_back(number[5]);
  primaries.mass.push_back(number[6]);
  inverse_mass.push_back(1. / number[6]); // what is fixed meets no walls
  force.push_back({number[7], number[8]});
  number += 9;
  if (rotations)
    primaries.angular_velocity.push_back(*number++);
  if (share->carried().start)
    primaries.start.push_back({number[0], number[1]});
  if (share->carried().strength) // of no consequence at a wall
    primaries.strength.push_back(1.);
}

void Dynamics::tell_of_walls(std::vector<double> &normal, std::vector<double> &tangential)
{
  // Walls that are free have moved where their contacts were swept.
  std::vector<std::array<double, 2>> velocity(normal.size());
  std::copy_n(bodies.velocity.begin() + primaries.size(), velocity.size(), velocity.begin());
  share->exchange.share({{first_rank, normal.data(), normal.size()},
                         {first_rank, tangential.data(), tangential.size()},
                         {first_rank, velocity.data()->data(), 2 * velocity.size()}});
  std::copy(velocity.begin(), velocity.end(), bodies.velocity.begin() + primaries.size());
}

void save_memory(const Dynamics &dynamics, StateWriter &out, const std::string &name)
{
  const contact::NeighbourList &list = dynamics.present().neighbours();
  const StripShare *const share = dynamics.strips();
  const std::vector<double> &values = list.memory().values();
  const std::size_t width = list.memory().n_impulses(), n_here = list.memory().size();
  if (share == nullptr)
  {
    out.write_rows(name, n_here, width,
                   [&](const std::size_t begin, const std::size_t end, double *const rows)
                   { std::copy(&values[begin * width], values.data() + end * width, rows); });
    return;
  }
  const TileRows tiles = rows_of_tiles(share->exchange, list.tile_start()[list.colour_start()[1]], n_here);
  out.write_rows(name, tiles.n_all, width,
                 [&](const std::size_t begin, const std::size_t end, double *const rows)
                 { bring_tiles(share->exchange, values, width, tiles, begin, end, rows); });
}

void Dynamics::build_list(const contact::ImageLattice &lattice,
                          const StateReader &in,
                          const std::string &name)
{
  if (share)
  {
    drop_guests();
    list.memory().forget(0, list.n_pairs());
    share->share_out(primaries, kept, list);
    weigh();
    take_tiles(share->exchange, in, name, list);
    return;
  }
  list.build(primaries.position, lattice);
  contact::PairMemory &memory = list.memory();
  const std::size_t width = memory.n_impulses();
  in.read_rows(name, memory.values().size() / width, width,
               [&](const std::size_t begin, const std::size_t end, const double *const rows)
               { std::copy(rows, rows + (end - begin) * width, memory.values().data() + begin * width); });
}
} // namespace softgrain::bpm
