// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_exchanges_h
#define softgrain_contact_disk_exchanges_h

#include <softgrain/base/exchange.h>

#include <cstdint>
#include <vector>

namespace softgrain::contact
{
/// Bodies whose velocities go to another owner, or come from it; both list them in the same order.
struct DiskExchange
{
  unsigned int other = 0; ///< number of that owner
  std::vector<std::uint32_t> bodies;
  std::vector<double> numbers; ///< velocities on their way
};

/// What owners tell each other at one time, at most one list each way between two of them.
struct DiskRound
{
  std::vector<DiskExchange> send, receive;

  /// @tparam n components
  /// @param at gives the place of component c of body i
  template <unsigned int n, class At>
  void exchange(const Exchange &exchange, const At &at)
  {
    std::vector<Exchange::Message> outgoing, incoming;
    for (DiskExchange &one : send)
    {
      one.numbers.resize(n * one.bodies.size());
      for (std::size_t i = 0; i < one.bodies.size(); ++i)
        for (unsigned int c = 0; c < n; ++c)
          one.numbers[n * i + c] = at(one.bodies[i], c);
      outgoing.push_back({one.other, one.numbers.data(), one.numbers.size()});
    }
    for (DiskExchange &one : receive)
    {
      one.numbers.resize(n * one.bodies.size());
      incoming.push_back({one.other, one.numbers.data(), one.numbers.size()});
    }
    exchange.swap(outgoing, incoming);
    for (const DiskExchange &one : receive)
      for (std::size_t i = 0; i < one.bodies.size(); ++i)
        for (unsigned int c = 0; c < n; ++c)
          at(one.bodies[i], c) = one.numbers[n * i + c];
  }
};

/**
 * @brief What owners tell each other where each of them has its own bodies and contacts alone.
 *
 * An owner has whole tiles. Its contacts have the tiles of all, those of others without contacts. Contacts
 * with walls are with the first one, which has copies of the bodies that take part.
 */
struct DiskExchanges
{
  std::vector<std::vector<DiskRound>> rounds; ///< one after the other, behind each colour; walls are the last
  /// End of the tiles of every owner for every colour; all lie one after the other.
  std::vector<std::vector<std::uint32_t>> end_of_tiles;
  unsigned int n_walls = 0; ///< with contacts, anywhere
  bool rotate = false;      ///< who owns no bodies cannot know
};
} // namespace softgrain::contact

#endif
