// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/parameters/replaced_names.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace softgrain
{
namespace
{
using Assignments = std::vector<ParameterAssignment>;

bool lists_names(const ParameterAssignment &assignment)
{
  return assignment.key == "Names" && assignment.sections.size() == 1;
}

std::set<std::string> names_in(const ParameterAssignment &list)
{
  const std::vector<std::string> names = dealii::Utilities::split_string_list(list.value, ',');
  return {names.begin(), names.end()};
}

/// The file of "FILE:LINE"; "--set" is as good as one.
std::string source_of(const ParameterAssignment &assignment)
{
  const auto colon = assignment.where.find_last_of(':');
  const bool line = colon != std::string::npos &&
                    assignment.where.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  return line ? assignment.where.substr(0, colon) : assignment.where;
}

/// Section and name of the subsection that an assignment belongs to; empty at the top.
std::pair<std::string, std::string> subsection_of(const ParameterAssignment &assignment)
{
  return assignment.sections.size() < 2 ? std::pair<std::string, std::string>{}
                                        : std::pair{assignment.sections[0], assignment.sections[1]};
}

/// A list that counts, and what it takes the place of.
struct Replacement
{
  std::size_t last = 0; ///< which assignment counts
  const ParameterAssignment *replaced = nullptr;
  std::set<std::string> gone, added; ///< names that it leaves out and brings
};

/// Lists of which there is more than one, by their sections.
std::map<std::string, Replacement> replacements(const Assignments &assignments)
{
  std::map<std::string, std::vector<std::size_t>> lists;
  for (std::size_t i = 0; i < assignments.size(); ++i)
    if (lists_names(assignments[i]))
      lists[assignments[i].sections[0]].push_back(i);
  std::map<std::string, Replacement> found;
  for (const auto &[section, places] : lists)
    if (places.size() > 1)
    {
      Replacement replacement{
          places.back(), &assignments[*(places.end() - 2)], {}, names_in(assignments[places.back()])};
      const std::set<std::string> kept = replacement.added;
      for (auto place = places.begin(); place + 1 != places.end(); ++place)
        for (const std::string &name : names_in(assignments[*place]))
        {
          replacement.added.erase(name);
          if (kept.count(name) == 0)
            replacement.gone.insert(name);
        }
      found.emplace(section, replacement);
    }
  return found;
}

void complain_of_empty(const Assignments &assignments,
                       const std::string &section,
                       const Replacement &list,
                       Mistakes &mistakes)
{
  if (list.gone.empty())
    return;
  for (const std::string &name : list.added)
  {
    if (std::any_of(assignments.begin(), assignments.end(),
                    [&](const ParameterAssignment &a) {
                      return subsection_of(a) == std::pair{section, name} && !a.key.empty();
                    }))
      continue;
    const std::string near = nearest_name(name, {list.gone.begin(), list.gone.end()});
    mistakes.add(assignments[list.last].where + ": '" + section + "/Names' has '" + name +
                     "', of which nothing is set" + (near.empty() ? "" : " (did you mean '" + near + "'?)") +
                     "; " + list.replaced->where + " has '" + list.replaced->value + "'",
                 section + "/" + name + "/");
  }
}
} // namespace

Assignments without_replaced_names(const Assignments &assignments, Mistakes &mistakes)
{
  const std::map<std::string, Replacement> lists = replacements(assignments);
  for (const auto &[section, list] : lists)
    complain_of_empty(assignments, section, list, mistakes);
  Assignments kept;
  for (std::size_t i = 0; i < assignments.size(); ++i)
  {
    const auto [section, name] = subsection_of(assignments[i]);
    const auto list = lists.find(section);
    const bool gone = list != lists.end() && i < list->second.last && list->second.gone.count(name) > 0 &&
                      source_of(assignments[i]) != source_of(assignments[list->second.last]);
    if (!gone)
      kept.push_back(assignments[i]);
  }
  return kept;
}
} // namespace softgrain
