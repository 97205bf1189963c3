// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_share_h
#define softgrain_contact_disk_share_h

#include <softgrain/base/exchange.h>
#include <softgrain/contact/disk_exchanges.h>
#include <softgrain/contact/disk_system.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace softgrain::contact
{
/// Contacts from @p first to before @p last, swept one after the other.
struct ContactRange
{
  std::uint32_t first, last;
};

/**
 * @brief Which of the contacts between disks this rank sweeps, and what it tells others after every colour.
 *
 * Tiles of a colour lie in the order of their places, so every rank takes consecutive ones, about as many
 * contacts as the others. Contacts with walls, swept one after the other, are those of the first rank. A body
 * of contacts of several ranks is at all of them: who has changed it in one colour tells the others before
 * the next. So each contact meets the same velocities as with one rank, to the last bit.
 *
 * All ranks know all contacts and bodies, or each knows its own alone: then it is told what to exchange.
 *
 * Bodies have the numbers that the caller gives them, see @p number_of of the constructors.
 */
class DiskShare
{
public:
  /**
   * @param exchange by which they tell each other; more than one
   * @param contacts that all of them know
   * @param number_of number of each body of the contacts, below @p n_bodies
   * @param n_bodies number of bodies with contacts
   * @param ranges by colour; the last one holds the contacts with walls
   * @param colour_end ranges before the end of each colour
   */
  DiskShare(const Exchange &exchange,
            const ContactOrder &contacts,
            const std::vector<std::uint32_t> &number_of,
            std::size_t n_bodies,
            const std::vector<ContactRange> &ranges,
            const std::vector<std::uint32_t> &colour_end);

  /// Shares among ranks that each know their own contacts: @p exchanges says what belongs to whom, of tiles
  /// that are the
  /// @p ranges; the other arguments are those above.
  DiskShare(const Exchange &exchange,
            const DiskExchanges &exchanges,
            const std::vector<std::uint32_t> &number_of,
            std::size_t n_bodies,
            const std::vector<ContactRange> &ranges);

  /// Whether each rank knows its own contacts and bodies alone.
  bool apart() const { return is_apart; }

  /// Ranges of a colour that are swept here: first and end. The colour after the last is that of the walls.
  std::pair<std::uint32_t, std::uint32_t> own_ranges(const std::size_t colour) const
  {
    return range_of(colour, exchange.here());
  }

  std::size_t n_colours() const { return end_of.size(); } ///< that of the walls included

  /// Numbers of the bodies that contacts of this rank have.
  const std::vector<std::uint32_t> &own_bodies() const { return touched; }

  /**
   * @brief Brings other ranks, after a colour, velocities of the bodies that they have to know, or that they
   * have changed.
   * @param colour that has just been swept
   * @param at gives the place of component c of body i
   */
  template <unsigned int n, class At>
  void tell(const std::size_t colour, const At &at)
  {
    for (DiskRound &round : rounds[colour])
      round.template exchange<n>(exchange, at);
  }

  /// Gives all ranks the velocities of all bodies, as tell() does.
  template <unsigned int n, class At>
  void tell_all(const At &at)
  {
    std::vector<Exchange::Piece> pieces;
    for (DiskExchange &one : owned)
    {
      each<n>(one, [&](double &number, const std::uint32_t body, const unsigned int c)
              { number = one.other == exchange.here() ? at(body, c) : 0.; });
      pieces.push_back({one.other, one.numbers.data(), one.numbers.size()});
    }
    exchange.share(pieces);
    for (DiskExchange &one : owned)
      if (one.other != exchange.here())
        each<n>(one, [&](const double number, const std::uint32_t body, const unsigned int c)
                { at(body, c) = number; });
  }

  /// Gives all ranks what each has in the contacts that it sweeps, of one vector with a number per contact.
  void share_contacts(std::vector<double> &of_contacts) const;
  /// Shares a vector with a number per range.
  void share_ranges(std::vector<double> &of_ranges) const;
  /// Gives all ranks what the one has that sweeps contacts with walls; of the same size on all.
  void share_walls(std::vector<double> &of_walls) const;
  /// Makes each of the numbers the largest that a rank has of it, or not a number where one rank says so.
  void take_largest(std::vector<double> &numbers) const;

private:
  template <unsigned int n, class Work>
  static void each(DiskExchange &one, const Work &work)
  {
    one.numbers.resize(n * one.bodies.size());
    for (std::size_t i = 0; i < one.bodies.size(); ++i)
      for (unsigned int c = 0; c < n; ++c)
        work(one.numbers[n * i + c], one.bodies[i], c);
  }

  std::pair<std::uint32_t, std::uint32_t> range_of(std::size_t colour, unsigned int rank) const;
  void divide(const std::vector<std::uint32_t> &colour_end);
  struct Touching;
  Touching who_touches(const ContactOrder &contacts,
                       const std::vector<std::uint32_t> &number_of,
                       std::size_t n_bodies) const;
  void find_exchanges(const ContactOrder &contacts,
                      const std::vector<std::uint32_t> &number_of,
                      std::size_t n_bodies);
  /// Calls work(colour, rank, number of a body) for both bodies of every contact.
  template <class Work>
  void for_bodies(const ContactOrder &contacts,
                  const std::vector<std::uint32_t> &number_of,
                  const Work &work) const;
  /// Gives all ranks what each has in its parts of @p numbers; part(begin, end) says where that of some
  /// ranges begins and ends.
  template <class Part>
  void share(std::vector<double> &numbers, const Part &part) const;

  const Exchange &exchange;
  const std::vector<ContactRange> &ranges;
  const bool is_apart;
  std::vector<std::vector<std::uint32_t>> end_of; ///< of the ranges of a rank, by colour
  std::vector<std::vector<DiskRound>> rounds;     ///< by colour
  std::vector<DiskExchange> owned;                ///< every body once, with the lowest rank that has it
  std::vector<std::uint32_t> touched;
};
} // namespace softgrain::contact

#endif
