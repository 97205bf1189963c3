// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/scene/pair_table.h>
#include <softgrain/scene/scene_parameters.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
bool has(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The two parts of @p text around the first @p separator.
std::pair<std::string, std::string> split(const std::string &text, const char separator)
{
  const auto place = text.find(separator);
  if (place == std::string::npos)
    return {dealii::Utilities::trim(text), ""};
  return {dealii::Utilities::trim(text.substr(0, place)), dealii::Utilities::trim(text.substr(place + 1))};
}

void check_name(const std::string &what, const std::string &name, const SceneNames &names)
{
  const int kinds = has(names.materials, name) + has(names.bodies, name) + has(names.walls, name);
  if (kinds > 1)
    throw InputError(what + ": more than one of a material, a body and a wall is named '" + name +
                     "': give them names of their own");
  if (kinds == 1)
    return;
  std::vector<std::string> known = names.materials;
  known.insert(known.end(), names.bodies.begin(), names.bodies.end());
  known.insert(known.end(), names.walls.begin(), names.walls.end());
  const std::string near = nearest_name(name, known);
  throw InputError(what + ": no material, body or wall is named '" + name + "'; there are: " + join(known) +
                   (near.empty() ? "" : " (did you mean '" + near + "'?)"));
}

PairValue parse_pair(const std::string &what, const std::string &entry, const SceneNames &names)
{
  const auto [pair, number] = split(entry, ':');
  const auto [first, second] = split(pair, '/');
  if (first.empty() || second.empty() || !dealii::Patterns::Double().match(number))
    throw InputError(what + ": '" + entry + "' is not allowed: it must be 'first / second: number'");
  check_name(what, first, names);
  check_name(what, second, names);
  if (has(names.walls, first) && has(names.walls, second))
    throw InputError(what + ": '" + pair + "' are two walls, which never touch");
  const double value = dealii::Utilities::string_to_double(number);
  if (!(value >= 0.) || !std::isfinite(value))
    throw InputError(what + ": '" + entry + "' is not allowed: the number must be 0 or more");
  return {first, second, value};
}
} // namespace

std::vector<PairValue> parse_pairs(const std::string &path, const std::string &text, const SceneNames &names)
{
  const std::string what = "'" + path + "' = '" + text + "'";
  std::vector<PairValue> table;
  if (dealii::Utilities::trim(text).empty())
    return table;
  for (const std::string &entry : dealii::Utilities::split_string_list(text, ';'))
  {
    const PairValue pair = parse_pair(what, entry, names);
    for (const PairValue &other : table)
      if ((other.first == pair.first && other.second == pair.second) ||
          (other.first == pair.second && other.second == pair.first))
        throw InputError(what + ": the pair '" + pair.text() + "' comes twice");
    table.push_back(pair);
  }
  return table;
}
} // namespace softgrain
