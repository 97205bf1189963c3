// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/parameters/parameter_file.h>
#include <softgrain/parameters/parameter_home.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/parameters/replaced_names.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace softgrain
{
namespace
{
/// Longer ones would be too long for the names of files that they become a part of.
constexpr std::size_t longest_name = 100;

/// Lists longer than this would hide the message.
constexpr unsigned int max_names_in_message = 16;

/// Editors of Windows begin a text with it.
const std::string byte_order_mark = "\xEF\xBB\xBF";

/// A section, parameter or word of a choice that nobody has declared; a library might.
class UnknownName : public InputError
{
public:
  using InputError::InputError;
};

std::string
suggestion(const std::string &word, const std::vector<std::string> &names, const std::string &what)
{
  const std::string near = nearest_name(word, names);
  std::string text;
  if (!near.empty())
    text += " (did you mean '" + near + "'?)";
  if (names.empty())
    text += "; there are no " + what + " here";
  else if (names.size() <= max_names_in_message)
    text += "; " + what + " here: " + join(names);
  return text;
}

const ParameterSection &find_section(const ParameterSection &top, const ParameterAssignment &assignment)
{
  const ParameterSection *here = &top;
  std::string path;
  for (const std::string &name : assignment.sections)
  {
    const ParameterSection *next = here->section(name);
    path += (path.empty() ? "" : "/") + name;
    if (next == nullptr)
      throw UnknownName(assignment.where + ": unknown section '" + path + "'" +
                        suggestion(name, here->section_names(), "sections"));
    here = next;
  }
  return *here;
}

/// What became of a parameter that older versions had.
struct Former
{
  std::string path;
  std::string now; ///< its name today; empty when it is gone
  std::string why;
};

const std::vector<Former> &former_parameters()
{
  static const std::vector<Former> list = {
      {"Quasi-static/Held motion", "", "bodies are in balance when the forces on them are"},
      {"Contact/Position repair", "", "contact leaves no penetration that would have to be repaired"},
      {"Primaries/Solid fraction", "", "bodies are cut out of a dense packing of primaries"}};
  return list;
}

/// What to do about a parameter of an older version; empty when there was none of that name.
std::string what_became_of(const std::string &path)
{
  for (const Former &former : former_parameters())
    if (former.path == path)
      return (former.now.empty() ? "is gone: take the line out" : "is '" + former.now + "' now") +
             (former.why.empty() ? "" : " (" + former.why + ")");
  return "";
}

const ParameterEntry &
find_entry(const ParameterSection &top, const ParameterAssignment &assignment, const ValueOfEntry &value)
{
  const std::string path = parameter_path(assignment.sections, assignment.key);
  if (const std::string now = what_became_of(path); !now.empty())
    throw InputError(assignment.where + ": '" + path + "' " + now);
  const ParameterSection &section = find_section(top, assignment);
  if (const ParameterEntry *entry = section.entry(assignment.key))
    return *entry;
  if (section.section(assignment.key) != nullptr)
    throw InputError(assignment.where + ": '" + path + "' is a section, not a parameter");
  const std::vector<std::string> names = section.entry_names();
  const std::string home =
      nearest_name(assignment.key, names).empty() ? home_in_words(top, assignment, value) : "";
  throw UnknownName(
      assignment.where + ": unknown parameter '" + path + "'" +
      (home.empty() ? suggestion(assignment.key, names, "parameters") : "; it belongs in " + home));
}

/// The first number of a value whose pattern asks for numbers that no double holds: 1e-308 loses digits,
/// 1e999 is infinite. Nothing when all are fine.
std::string number_out_of_range(const std::string &pattern, const std::string &value)
{
  if (pattern.find("[Double") == std::string::npos)
    return "";
  std::istringstream words(value);
  for (std::string list; std::getline(words, list, ';');)
    for (const std::string &number : dealii::Utilities::split_string_list(list, ","))
    {
      errno = 0;
      std::strtod(number.c_str(), nullptr);
      if (errno == ERANGE)
        return number;
    }
  return "";
}

void check_names(const std::vector<std::string> &names, const std::string &section, const std::string &where)
{
  const std::string path = "'" + section + "/Names'";
  for (auto name = names.begin(); name != names.end(); ++name)
  {
    // "value" is how deal.II's tree tells a parameter from a section.
    if (name->empty() || *name == "value" || *name == "Names" ||
        !std::all_of(name->begin(), name->end(),
                     [](const unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; }))
      throw InputError(where + ": " + path + ": '" + *name +
                       "' cannot be a name: use letters, digits, '_' and '-'");
    if (name->size() > longest_name)
      throw InputError(where + ": " + path + ": '" + name->substr(0, 20) + "...' cannot be a name: it has " +
                       std::to_string(name->size()) + " letters, " + std::to_string(longest_name) +
                       " are allowed");
    if (std::find(names.begin(), name, *name) != name)
      throw InputError(where + ": " + path + " has '" + *name + "' twice");
  }
}
} // namespace

std::string read_text_file(const std::string &file_name)
{
  std::error_code error;
  if (!std::filesystem::exists(file_name, error))
  {
    if (error == std::errc::filename_too_long)
      throw InputError(file_name.substr(0, 40) + "...: file name too long");
    throw InputError(file_name + ": there is no such file");
  }
  if (std::filesystem::is_directory(file_name, error))
    throw InputError(file_name + ": is a folder, not a parameter file");
  std::ifstream file(file_name, std::ios::binary);
  std::ostringstream text;
  if (!file || (file.peek() != std::ifstream::traits_type::eof() && !(text << file.rdbuf())))
    throw InputError(file_name + ": cannot be read");
  std::string content = text.str();
  if (content.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
    content.erase(0, byte_order_mark.size());
  if (std::any_of(content.begin(), content.end(),
                  [](const unsigned char c)
                  { return c < 32 && c != '\n' && c != '\r' && c != '\t' && c != '\f'; }))
    throw InputError(file_name + ": is not a text file");
  return content;
}

ParameterFile::ParameterFile(const std::string &file_name, Mistakes &mistakes)
    : name(file_name)
    , assignments(std::filesystem::path(file_name).extension() == ".json"
                      ? read_json_file(file_name, mistakes)
                      : read_prm_file(file_name, mistakes))
{
}

ParameterFile::ParameterFile(const std::string &file_name) : name(file_name)
{
  Mistakes mistakes;
  *this = ParameterFile(file_name, mistakes);
  mistakes.end();
}

std::string ParameterFile::located(const std::string &message) const
{
  const auto begin = message.find('\''), end = message.find('\'', begin + 1);
  std::vector<std::string> path;
  if (begin != std::string::npos && end != std::string::npos)
    path = dealii::Utilities::split_string_list(message.substr(begin + 1, end - begin - 1), '/');
  if (path.empty())
    return name + ": " + message;
  const std::string key = path.back();
  path.pop_back();
  return where(path, key) + ": " + message;
}

void ParameterFile::set(const std::string &text)
{
  const auto equals = text.find('=');
  const std::string example = "; write --set \"Section/Sub/Key=value\"";
  if (equals == std::string::npos)
    throw InputError("--set: '" + text + "' has no '='" + example);
  ParameterAssignment assignment;
  assignment.where = "--set";
  assignment.value = dealii::Utilities::trim(text.substr(equals + 1));
  std::istringstream path(text.substr(0, equals));
  std::string part;
  while (std::getline(path, part, '/'))
    assignment.sections.push_back(dealii::Utilities::trim(part));
  if (assignment.sections.empty() || assignment.sections.back().empty())
    throw InputError("--set: '" + text + "' names no parameter" + example);
  assignment.key = assignment.sections.back();
  assignment.sections.pop_back();
  assignments.push_back(assignment);
}

namespace
{
/// The folder of the file that "FILE:LINE" or "FILE" names.
std::filesystem::path folder_of(const std::string &where)
{
  const auto colon = where.find_last_of(':');
  const bool line = colon != std::string::npos && colon + 1 < where.size() &&
                    where.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  return std::filesystem::path(line ? where.substr(0, colon) : where).parent_path();
}

/// @p path as it is found from where the program was started.
std::string resolved(const std::string &path, const std::filesystem::path &folder)
{
  const std::filesystem::path there = folder / path;
  std::error_code ignored;
  // A library without a folder may be one that the loader finds by its name.
  if (path.find('/') == std::string::npos && path.find(".so") != std::string::npos &&
      !std::filesystem::exists(there, ignored))
    return path;
  return there.lexically_normal().string();
}
} // namespace

void ParameterFile::resolve_paths(const std::vector<std::string> &paths)
{
  for (ParameterAssignment &assignment : assignments)
  {
    const std::filesystem::path folder = folder_of(assignment.where);
    if (assignment.where == "--set" || folder.empty() || assignment.value.empty() ||
        std::find(paths.begin(), paths.end(), parameter_path(assignment.sections, assignment.key)) ==
            paths.end())
      continue;
    std::string changed;
    for (const std::string &path : dealii::Utilities::split_string_list(assignment.value))
      changed += (changed.empty() ? "" : ", ") + resolved(path, folder);
    assignment.value = changed;
  }
}

const ParameterAssignment *ParameterFile::find(const std::vector<std::string> &sections,
                                               const std::string &key) const
{
  const auto found =
      std::find_if(assignments.rbegin(), assignments.rend(),
                   [&](const ParameterAssignment &a) { return a.key == key && a.sections == sections; });
  return found == assignments.rend() ? nullptr : &*found;
}

std::string ParameterFile::value(const std::vector<std::string> &sections,
                                 const std::string &key,
                                 const std::string &otherwise) const
{
  const ParameterAssignment *found = find(sections, key);
  return found == nullptr ? otherwise : found->value;
}

std::string ParameterFile::where(const std::vector<std::string> &sections, const std::string &key) const
{
  const ParameterAssignment *found = find(sections, key);
  return found == nullptr ? name : found->where;
}

std::vector<std::string> ParameterFile::names(const std::string &section) const
{
  const std::string text = value({section}, "Names", "");
  if (text.empty())
    return {};
  std::vector<std::string> names;
  std::istringstream stream(text);
  std::string part;
  while (std::getline(stream, part, ','))
    names.push_back(dealii::Utilities::trim(part));
  check_names(names, section, where({section}, "Names"));
  return names;
}

namespace
{
/// Sets one parameter. @throw InputError when it is not declared or its value is not allowed
void apply_one(dealii::ParameterHandler &prm,
               const ParameterSection &top,
               const ParameterAssignment &assignment,
               const ValueOfEntry &value)
{
  const ParameterEntry &entry = find_entry(top, assignment, value);
  const std::string is = assignment.where + ": '" + parameter_path(assignment.sections, assignment.key) +
                         "' = '" + assignment.value + "' is not allowed: ";
  const std::string bad_number = number_out_of_range(entry.pattern, assignment.value);
  if (!bad_number.empty())
    throw InputError(is + bad_number +
                     " is not between 2.3e-308 and 1.7e308 in size, where numbers have all their digits");
  bool allowed = true;
  for (const std::string &section : assignment.sections)
    prm.enter_subsection(section);
  try
  {
    prm.set(assignment.key, assignment.value);
  }
  catch (const dealii::ExceptionBase &)
  {
    allowed = false;
  }
  for (std::size_t i = 0; i < assignment.sections.size(); ++i)
    prm.leave_subsection();
  if (allowed)
    return;
  const std::vector<std::string> words = choices(entry.pattern);
  const std::string near = nearest_name(assignment.value, words);
  const std::string message = is + "it must be " + allowed_in_words(entry.pattern) +
                              (near.empty() ? "" : " (did you mean '" + near + "'?)");
  if (!words.empty())
    throw UnknownName(message);
  throw InputError(message);
}
} // namespace

void ParameterFile::apply(dealii::ParameterHandler &prm) const
{
  Mistakes mistakes;
  apply(prm, mistakes);
  mistakes.end();
}

void ParameterFile::apply(dealii::ParameterHandler &prm,
                          Mistakes &mistakes,
                          std::vector<std::string> *const unknown) const
{
  const ParameterSection top = parameter_tree(prm);
  const ValueOfEntry value_of = [this](const std::vector<std::string> &sections, const ParameterEntry &entry)
  { return value(sections, entry.name, entry.default_value); };
  std::vector<std::string> unknown_sections;
  for (const ParameterAssignment &assignment : without_replaced_names(assignments, mistakes))
  {
    const bool of_section = assignment.key.empty();
    const std::string path = parameter_path(assignment.sections, assignment.key);
    // One word about an unknown section is enough for all that is in it.
    if (std::any_of(unknown_sections.begin(), unknown_sections.end(),
                    [&](const std::string &section)
                    { return path.compare(0, section.size(), section) == 0; }))
      continue;
    try
    {
      if (of_section)
        find_section(top, assignment);
      else
        apply_one(prm, top, assignment, value_of);
    }
    catch (const UnknownName &error)
    {
      if (unknown == nullptr)
        mistakes.add(error.what(), path);
      else
      {
        mistakes.doubt(path);
        unknown->push_back(
            assignment.where + ": '" +
            (of_section ? path.substr(0, path.size() - 1) + "'" : path + "' = '" + assignment.value + "'"));
      }
      if (of_section)
        unknown_sections.push_back(path);
    }
    catch (const InputError &error)
    {
      mistakes.add(error.what(), path);
    }
  }
}
} // namespace softgrain
