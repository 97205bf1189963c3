// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_file.h>
#include <softgrain/parameters/parameter_home.h>
#include <softgrain/parameters/parameter_tree.h>

#include <algorithm>
#include <cctype>

namespace softgrain
{
namespace
{
using Path = std::vector<std::string>;

/// Lists longer than this would hide the message.
constexpr std::size_t max_homes = 6;

/// 'Neo-Hookean' and 'neo_hookean' are one law.
std::string plain(const std::string &name)
{
  std::string letters;
  for (const unsigned char c : name)
    if (std::isalnum(c))
      letters += static_cast<char>(std::tolower(c));
  return letters;
}

/// Paths of @p section, which @p path leads to, and of all below it that have a parameter @p key.
void find_homes(const ParameterSection &section,
                const std::string &key,
                const Path &path,
                std::vector<Path> &homes)
{
  if (!path.empty() && section.entry(key) != nullptr)
    homes.push_back(path);
  for (const ParameterSection &child : section.sections)
  {
    Path below = path;
    below.push_back(child.name);
    find_homes(child, key, below, homes);
  }
}

const ParameterSection *section_at(const ParameterSection &top, const Path &path)
{
  const ParameterSection *here = &top;
  for (const std::string &name : path)
    if (here != nullptr)
      here = here->section(name);
  return here;
}

/// Whether a word that the section above has chosen is the name of the last section of @p path.
bool is_chosen(const ParameterSection &top, Path path, const ValueOfEntry &value)
{
  const std::string name = plain(path.back());
  path.pop_back();
  const std::vector<ParameterEntry> &entries = section_at(top, path)->entries;
  return std::any_of(entries.begin(), entries.end(),
                     [&](const ParameterEntry &entry)
                     { return !choices(entry.pattern).empty() && plain(value(path, entry)) == name; });
}
} // namespace

std::string
home_in_words(const ParameterSection &top, const ParameterAssignment &assignment, const ValueOfEntry &value)
{
  std::vector<Path> homes;
  for (Path from = assignment.sections; homes.empty(); from.pop_back())
  {
    if (const ParameterSection *const section = section_at(top, from))
      find_homes(*section, assignment.key, from, homes);
    if (from.empty())
      break;
  }
  const auto chosen =
      std::find_if(homes.begin(), homes.end(), [&](const Path &path) { return is_chosen(top, path, value); });
  if (chosen != homes.end())
    homes = std::vector<Path>(1, Path(*chosen));
  if (homes.empty())
    return "";
  std::string text = homes.size() == 1 ? "section " : "one of the sections ";
  for (std::size_t i = 0; i < std::min(homes.size(), max_homes); ++i)
  {
    const std::string name = homes[i].back();
    homes[i].pop_back();
    text += (i == 0 ? "'" : ", '") + parameter_path(homes[i], name) + "'";
  }
  return text + (homes.size() > max_homes ? " or others" : "");
}
} // namespace softgrain
