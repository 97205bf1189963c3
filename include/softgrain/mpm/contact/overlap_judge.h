// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_overlap_judge_h
#define softgrain_mpm_contact_overlap_judge_h

#include <softgrain/geometry/outline_overlap.h>
#include <softgrain/mpm/contact/contact_tasks.h>

#include <tuple>
#include <utility>
#include <vector>

namespace softgrain::mpm
{
/// Share of the width of the narrower of two bodies by which they may come nearer without a look at what is
/// in between: half of the material of a strip or a ring.
constexpr double largest_way_in_widths = 0.25;

/// Width of a body where it is narrowest, as it is now: the diameter of a disk, twice the width of a strip or
/// of the material of a ring [m].
double width_of(const Body<2> &body);

/// Two that meet: a body and another, a wall or an obstacle.
struct Meeting
{
  enum class With
  {
    body,
    wall,
    obstacle
  };

  With with = With::body;
  unsigned int body = 0, other = 0; ///< their numbers

  /// Numbers that two bodies have in either order.
  std::tuple<With, unsigned int, unsigned int> key() const;
};

/**
 * @brief What is wrong with a step as it came out, seen from the outlines of bodies alone.
 *
 * What meets in it is found without the contact rows: it does not know what they have missed.
 */
struct Verdict
{
  Intrusion deepest; ///< of all pairs
  Meeting overlap;   ///< whose that is
  double way = 0;    ///< largest way of a pair that passes on it, over what is seen at its ends; 0: none does
  Meeting passing;   ///< whose that is
  /// The pairs that lie deepest in each other, once each, the deepest first; no more than most_deep.
  std::vector<std::pair<double, Meeting>> deep;
  static constexpr unsigned int most_deep = 16;

  /// Becomes the worse of both in each; of equal ones that of the body with the lower number.
  void take(const Verdict &other);
  void take(const Intrusion &found, const Meeting &meeting);
  void take_way(double share, const Meeting &meeting);
  void note_deep(double depth, const Meeting &meeting);

  using Numbers = std::vector<double>; ///< always as many
  Numbers numbers() const;
  static Verdict of(const Numbers &numbers);
};

/**
 * @brief Judges a step by the outlines of owned bodies at its end.
 * @param scene at the end of the step
 * @param moved the outlines there, and the pairs that may have met on the way
 */
Verdict judge_outlines(const OutlineScene &scene, const MovedOutlines &moved);
} // namespace softgrain::mpm

#endif
