// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_contact_loads_h
#define softgrain_analysis_contact_loads_h

#include <softgrain/analysis/snapshot.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// One of the loads that a user asks for.
struct LoadWish
{
  std::string on;   ///< a body, a wall or an obstacle
  std::string from; ///< its partner; empty: all of them together
};

/**
 * @brief Reads the value of 'Output/Forces on', "NAME, NAME / PARTNER, ...".
 * @throw InputError when an entry has another form
 */
std::vector<LoadWish> parse_load_wishes(const std::string &text);

/**
 * @brief What bodies, walls and obstacles feel where they touch: force and torque as columns of a table.
 *
 * A torque is counter-clockwise about the centre of mass of a body, the pivot of an obstacle, the point of a
 * wall that its position tells. What two partners do to each other is opposite.
 */
class ContactLoads
{
public:
  ContactLoads() = default;

  /**
   * @param wishes    in the order of the columns
   * @param bodies    their names, as in a snapshot
   * @param walls     the same
   * @param obstacles the same
   * @param repeats   of every wall, whether it is a side of a cell that repeats, which nothing touches
   * @throw InputErrors for what is not known, two things of one name, sides that repeat, and partners that
   * are one thing or never touch
   */
  ContactLoads(const std::vector<LoadWish> &wishes,
               const std::vector<std::string> &bodies,
               const std::vector<std::string> &walls,
               const std::vector<std::string> &obstacles,
               const std::vector<char> &repeats);

  bool empty() const { return wanted.empty(); }

  /// Names and values [N/m, N]; @p touching needs time, centres of bodies, walls, obstacles and contacts.
  std::vector<std::pair<std::string, double>> evaluate(const Snapshot<2> &touching) const;

  /// The same names without values, where no contact is known.
  std::vector<std::pair<std::string, double>> unknown() const;

private:
  /// A body by its index, or a wall, obstacles after walls.
  struct Place
  {
    bool is_body = false;
    std::size_t index = 0;
    bool operator==(const Place &other) const { return is_body == other.is_body && index == other.index; }
  };
  struct Wanted
  {
    std::string name; ///< begin of its columns
    Place on, from;
    bool of_all = true;
  };
  static dealii::Point<2> reference_of(const Place &place, const Snapshot<2> &touching);

  std::vector<Wanted> wanted;
};
} // namespace softgrain

#endif
