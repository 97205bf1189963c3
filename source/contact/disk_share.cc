// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/disk_share.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace softgrain::contact
{
namespace
{
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
} // namespace

DiskShare::DiskShare(const Exchange &exchange,
                     const ContactOrder &contacts,
                     const std::vector<std::uint32_t> &number_of,
                     const std::size_t n_bodies,
                     const std::vector<ContactRange> &ranges,
                     const std::vector<std::uint32_t> &colour_end)
    : exchange(exchange), ranges(ranges), is_apart(false)
{
  divide(colour_end);
  find_exchanges(contacts, number_of, n_bodies);
}

DiskShare::DiskShare(const Exchange &exchange,
                     const DiskExchanges &exchanges,
                     const std::vector<std::uint32_t> &number_of,
                     const std::size_t n_bodies,
                     const std::vector<ContactRange> &ranges)
    : exchange(exchange)
    , ranges(ranges)
    , is_apart(true)
    , end_of(exchanges.end_of_tiles)
    , rounds(exchanges.rounds)
    , touched(n_bodies)
{
  end_of.emplace_back(exchange.number(), ranges.size());
  for (std::vector<DiskRound> &of_colour : rounds)
    for (DiskRound &round : of_colour)
      for (auto *const list : {&round.send, &round.receive})
        for (DiskExchange &one : *list)
          for (std::uint32_t &body : one.bodies)
            body = number_of[body];
  std::iota(touched.begin(), touched.end(), 0);
}

void DiskShare::divide(const std::vector<std::uint32_t> &colour_end)
{
  const unsigned int n = exchange.number();
  std::uint32_t begin = 0;
  for (const std::uint32_t end : colour_end)
  {
    double all = 0., before = 0.;
    for (std::uint32_t i = begin; i < end; ++i)
      all += ranges[i].last - ranges[i].first;
    std::vector<std::uint32_t> ends(n, end);
    std::uint32_t at = begin;
    for (unsigned int r = 0; r < n; ++r)
    {
      // A range belongs to the rank in whose part its middle lies.
      for (; at < end; ++at)
      {
        const double size = ranges[at].last - ranges[at].first;
        if ((before + 0.5 * size) * n >= (r + 1) * all && r + 1 < n)
          break;
        before += size;
      }
      ends[r] = at;
    }
    end_of.push_back(ends);
    begin = end;
  }
  end_of.emplace_back(n, begin + 1);
}

std::pair<std::uint32_t, std::uint32_t> DiskShare::range_of(const std::size_t colour,
                                                            const unsigned int rank) const
{
  const std::uint32_t begin = rank > 0     ? end_of[colour][rank - 1]
                              : colour > 0 ? end_of[colour - 1].back()
                                           : 0;
  return {begin, end_of[colour][rank]};
}

template <class Work>
void DiskShare::for_bodies(const ContactOrder &contacts,
                           const std::vector<std::uint32_t> &number_of,
                           const Work &work) const
{
  for (std::size_t colour = 0; colour < n_colours(); ++colour)
    for (unsigned int rank = 0; rank < exchange.number(); ++rank)
    {
      const auto [begin, end] = range_of(colour, rank);
      for (std::uint32_t range = begin; range < end; ++range)
        for (std::uint32_t i = ranges[range].first; i < ranges[range].last; ++i)
        {
          work(colour, rank, number_of[contacts.a[i]]);
          work(colour, rank, number_of[contacts.b[i]]);
        }
    }
}

/// Which ranks touch every body. Most bodies are with one rank only; those with more are few, and get a list
/// of their exchange.
struct DiskShare::Touching
{
  std::vector<std::uint32_t> lowest, list_of; ///< rank, and its list in ranks_of if it has one
  std::vector<char> is_here;
  std::vector<std::vector<unsigned int>> ranks_of;
};

DiskShare::Touching DiskShare::who_touches(const ContactOrder &contacts,
                                           const std::vector<std::uint32_t> &number_of,
                                           const std::size_t n_bodies) const
{
  Touching touching{std::vector<std::uint32_t>(n_bodies, none),
                    std::vector<std::uint32_t>(n_bodies, none),
                    std::vector<char>(n_bodies, 0),
                    {}};
  std::vector<std::uint32_t> &lowest = touching.lowest, &list_of = touching.list_of;
  std::vector<std::vector<unsigned int>> &ranks_of = touching.ranks_of;
  const unsigned int here = exchange.here();
  for_bodies(contacts, number_of,
             [&](std::size_t, const unsigned int rank, const std::uint32_t body)
             {
               if (rank == here)
                 touching.is_here[body] = 1;
               if (lowest[body] == none)
                 lowest[body] = rank;
               else if (lowest[body] != rank && list_of[body] == none)
               {
                 list_of[body] = ranks_of.size();
                 ranks_of.emplace_back();
               }
               lowest[body] = std::min<std::uint32_t>(lowest[body], rank);
             });
  for_bodies(contacts, number_of,
             [&](std::size_t, const unsigned int rank, const std::uint32_t body)
             {
               if (list_of[body] == none)
                 return;
               std::vector<unsigned int> &list = ranks_of[list_of[body]];
               if (std::find(list.begin(), list.end(), rank) == list.end())
                 list.push_back(rank);
             });
  return touching;
}

void DiskShare::find_exchanges(const ContactOrder &contacts,
                               const std::vector<std::uint32_t> &number_of,
                               const std::size_t n_bodies)
{
  const unsigned int here = exchange.here();
  const Touching touching = who_touches(contacts, number_of, n_bodies);
  const auto with = [](std::vector<DiskExchange> &list, const unsigned int rank) -> DiskExchange &
  {
    const auto found =
        std::find_if(list.begin(), list.end(), [rank](const DiskExchange &one) { return one.other == rank; });
    if (found != list.end())
      return *found;
    list.emplace_back();
    list.back().other = rank;
    return list.back();
  };
  rounds.assign(n_colours(), std::vector<DiskRound>(1));
  for_bodies(contacts, number_of,
             [&](const std::size_t colour, const unsigned int rank, const std::uint32_t body)
             {
               if (touching.list_of[body] == none)
                 return;
               if (rank == here)
               {
                 for (const unsigned int other : touching.ranks_of[touching.list_of[body]])
                   if (other != here)
                     with(rounds[colour][0].send, other).bodies.push_back(body);
               }
               else if (touching.is_here[body])
                 with(rounds[colour][0].receive, rank).bodies.push_back(body);
             });
  for (std::vector<DiskRound> &of_colour : rounds)
    for (auto *const list : {&of_colour[0].send, &of_colour[0].receive})
      for (DiskExchange &one : *list)
      {
        std::sort(one.bodies.begin(), one.bodies.end());
        one.bodies.erase(std::unique(one.bodies.begin(), one.bodies.end()), one.bodies.end());
      }
  owned.resize(exchange.number());
  for (unsigned int rank = 0; rank < exchange.number(); ++rank)
    owned[rank].other = rank;
  for (std::uint32_t body = 0; body < n_bodies; ++body)
  {
    owned[touching.lowest[body]].bodies.push_back(body);
    if (touching.is_here[body])
      touched.push_back(body);
  }
}

template <class Part>
void DiskShare::share(std::vector<double> &numbers, const Part &part) const
{
  std::vector<Exchange::Piece> pieces;
  for (std::size_t colour = 0; colour < n_colours(); ++colour)
    for (unsigned int rank = 0; rank < exchange.number(); ++rank)
    {
      const auto [begin, end] = range_of(colour, rank);
      if (begin == end)
        continue;
      const auto [first, last] = part(begin, end);
      pieces.push_back({rank, numbers.data() + first, last - first});
    }
  exchange.share(pieces);
}

void DiskShare::share_contacts(std::vector<double> &of_contacts) const
{
  share(of_contacts, [this](const std::uint32_t begin, const std::uint32_t end)
        { return std::make_pair(ranges[begin].first, ranges[end - 1].last); });
}

void DiskShare::share_ranges(std::vector<double> &of_ranges) const
{
  share(of_ranges,
        [](const std::uint32_t begin, const std::uint32_t end) { return std::make_pair(begin, end); });
}

void DiskShare::share_walls(std::vector<double> &of_walls) const
{
  exchange.share({{0, of_walls.data(), of_walls.size()}});
}

void DiskShare::take_largest(std::vector<double> &numbers) const
{
  for (const std::vector<double> &other : exchange.of_all(numbers))
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (!std::isnan(numbers[i]) && !(other[i] <= numbers[i]))
        numbers[i] = other[i];
}
} // namespace softgrain::contact
