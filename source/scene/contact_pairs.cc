// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/scene/contact_law.h>
#include <softgrain/scene/contact_pairs.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace softgrain
{
namespace
{
/// Bodies of one material that no entry tells apart, or a wall.
struct Side
{
  std::string material, body, wall; ///< what an entry may call it; empty: that it has not

  /// How well @p name fits: 2 the body or the wall itself, 1 its material, 0 not at all.
  int fits(const std::string &name) const
  {
    return name == body || name == wall ? 2 : name == material ? 1 : 0;
  }
};

/// What the table says of a pair, @p otherwise when it says nothing.
double look_up(const std::string &path,
               const std::vector<PairValue> &table,
               const Side &a,
               const Side &b,
               const double otherwise)
{
  const PairValue *best = nullptr;
  int best_fit = 0;
  for (const PairValue &entry : table)
  {
    const auto fit = [&](const Side &one, const Side &other)
    {
      const int first = one.fits(entry.first), second = other.fits(entry.second);
      return first == 0 || second == 0 ? 0 : first + second;
    };
    const int here = std::max(fit(a, b), fit(b, a));
    if (here == 0 || here < best_fit)
      continue;
    if (here == best_fit && entry.value != best->value)
      throw InputError("'" + path + "': '" + best->text() + "' and '" + entry.text() +
                       "' both tell of the same bodies: add an entry that names both of them");
    best = &entry;
    best_fit = here;
  }
  return best == nullptr ? otherwise : best->value;
}
} // namespace

bool has_friction(const Scene<2> &scene)
{
  const auto positive = [](const PairValue &pair) { return pair.value > 0.; };
  return scene.friction > 0. ||
         std::any_of(scene.friction_pairs.begin(), scene.friction_pairs.end(), positive) ||
         std::any_of(scene.walls.begin(), scene.walls.end(),
                     [](const WallDescription<2> &wall) { return wall.friction > 0.; });
}

std::string friction_in_words(const Scene<2> &scene)
{
  const auto value = [](const double friction)
  {
    std::ostringstream text;
    text << friction;
    return friction > 0. ? text.str() : std::string("none");
  };
  std::string text = value(scene.friction) + " between bodies";
  // Walls and obstacles with the same friction stand together, in the order of the file.
  std::vector<std::pair<double, std::string>> at;
  const auto add = [&](const std::string &name, const double friction)
  {
    const auto known =
        std::find_if(at.begin(), at.end(), [&](const auto &one) { return one.first == friction; });
    if (known == at.end())
      at.emplace_back(friction, name);
    else
      known->second += ", " + name;
  };
  for (const WallDescription<2> &wall : scene.walls)
    if (wall.type != WallDescription<2>::Type::periodic)
      add(wall.name, wall.friction);
  for (const ObstacleDescription<2> &obstacle : scene.obstacles)
    add(obstacle.name, obstacle.friction);
  if (at.size() == 1 && at.front().first == scene.friction && scene.friction_pairs.empty())
    return scene.friction > 0. ? value(scene.friction) + " everywhere" : "none";
  for (const auto &[friction, names] : at)
    text += "; " + value(friction) + " at " + names;
  for (const PairValue &pair : scene.friction_pairs)
    text += "; " + value(pair.value) + " of " + pair.text();
  const bool smooth =
      !at.empty() && std::all_of(at.begin(), at.end(), [](const auto &one) { return one.first == 0.; });
  if (scene.friction > 0. && smooth && scene.friction_pairs.empty())
    text += " ('Contact/Friction at walls' = 'same' gives it to walls)";
  return text;
}

std::optional<double> uniform_friction(const Scene<2> &scene)
{
  if (!scene.friction_pairs.empty() || (scene.contact_law != nullptr && scene.contact_law->adheres()))
    return std::nullopt;
  return scene.friction;
}

template <int dim>
ContactPairs::ContactPairs(const Scene<dim> &scene)
{
  std::set<std::string> named;
  for (const auto *table : {&scene.friction_pairs, &scene.adhesion_pairs})
    for (const PairValue &entry : *table)
      named.insert({entry.first, entry.second});
  std::vector<std::pair<unsigned int, std::string>> keys; // material and, where an entry names it, body
  std::vector<Side> sides;
  for (const BodyDescription<dim> &body : scene.bodies)
  {
    const std::pair<unsigned int, std::string> key = {body.material,
                                                      named.count(body.name) > 0 ? body.name : ""};
    const auto known = std::find(keys.begin(), keys.end(), key);
    group.push_back(known - keys.begin());
    if (known != keys.end())
      continue;
    keys.push_back(key);
    sides.push_back({scene.materials[body.material].name, key.second, ""});
  }
  n_groups = sides.size();
  columns = n_groups + scene.walls.size();
  for (const WallDescription<dim> &wall : scene.walls)
    sides.push_back({"", "", wall.name});
  const bool adheres = scene.contact_law != nullptr && scene.contact_law->adheres();
  for (unsigned int i = 0; i < n_groups; ++i)
    for (unsigned int j = 0; j < columns; ++j)
    {
      const double usual = j < n_groups ? scene.friction : scene.walls[j - n_groups].friction;
      frictions.push_back(
          look_up("Contact/Friction of pairs", scene.friction_pairs, sides[i], sides[j], usual));
      any_friction = any_friction || frictions.back() > 0.;
      if (!adheres)
        continue;
      adhesions.push_back(
          look_up("Contact/Adhesion of pairs", scene.adhesion_pairs, sides[i], sides[j], scene.adhesion));
      any_adhesion = any_adhesion || adhesions.back() > 0.;
    }
}

#ifdef __cplusplus // Doxygen, which has none, takes instantiations of constructors for others
template ContactPairs::ContactPairs(const Scene<2> &);
template ContactPairs::ContactPairs(const Scene<3> &);
#endif
} // namespace softgrain
