// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_pair_table_h
#define softgrain_scene_pair_table_h

#include <string>
#include <vector>

namespace softgrain
{
struct SceneNames;

/// One entry of a table of pairs.
struct PairValue
{
  std::string first, second; ///< a material, a body or a wall
  double value = 0;

  std::string text() const { return first + " / " + second; }
};

/**
 * @brief Reads a table of pairs, "first / second: value; ...".
 *
 * @param path      of the parameter, for messages
 * @param text      what it says
 * @param names     of the materials, bodies and walls of the scene
 * @throw InputError for what is no such table, names that nothing or two things have, a pair of walls, a pair
 * that comes twice, and values that are negative
 */
std::vector<PairValue> parse_pairs(const std::string &path, const std::string &text, const SceneNames &names);
} // namespace softgrain

#endif
