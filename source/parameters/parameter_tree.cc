// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_tree.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>

namespace softgrain
{
namespace
{
/// deal.II writes every character that is not a letter or digit as _XX, in hexadecimal.
std::string demangle(const std::string &name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == '_' && i + 2 < name.size())
    {
      result += static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
      i += 2;
    }
    else
      result += name[i];
  return result;
}

using Tree = boost::property_tree::ptree;

ParameterSection read_section(const std::string &name, const Tree &tree)
{
  ParameterSection section;
  section.name = name;
  for (const auto &[mangled, node] : tree)
  {
    const auto text = [&node = node](const char *const key) { return node.get<std::string>(key, ""); };
    if (node.find("value") != node.not_found() && node.get_child("value").empty())
      section.entries.push_back({demangle(mangled), text("value"), text("default_value"),
                                 text("documentation"), text("pattern_description")});
    else
      section.sections.push_back(read_section(demangle(mangled), node));
  }
  return section;
}

std::string trim(const std::string &text)
{
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

bool starts_with(const std::string &text, const std::string &start)
{
  return text.compare(0, start.size(), start) == 0;
}

/// "a...b" of a range pattern; deal.II's own extremes mean no bound.
std::string range_in_words(const std::string &noun, const std::string &range, const bool integer)
{
  const auto dots = range.find("...");
  std::string low = trim(range.substr(0, dots));
  std::string high = trim(range.substr(dots + 3, range.find('(') - dots - 3));
  const auto unbounded = [integer](const std::string &text)
  {
    return text.find("MAX_DOUBLE") != std::string::npos ||
           (integer && (text == std::to_string(std::numeric_limits<int>::max()) ||
                        text == std::to_string(std::numeric_limits<int>::min())));
  };
  const bool has_low = !unbounded(low), has_high = !unbounded(high);
  if (!has_low && !has_high)
    return noun;
  // Zero itself is excluded by a bound that is tiny beyond any physical meaning.
  const double low_value = has_low ? std::stod(low) : 0;
  const bool above_zero = has_low && !integer && low_value > 0 && low_value < 1e-200;
  std::string words = noun;
  if (has_low && has_high && !above_zero)
    return words + " between " + low + " and " + high;
  if (has_low)
    words += above_zero ? " greater than 0" : " of at least " + low;
  if (has_high)
    words += std::string(has_low ? " and" : " of") + " at most " + high;
  return words;
}

/// The bracketed pattern that starts at @p begin, its brackets included.
std::string inner_pattern(const std::string &text, const std::size_t begin)
{
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i)
    if (text[i] == '[')
      ++depth;
    else if (text[i] == ']' && --depth == 0)
      return text.substr(begin, i - begin + 1);
  return text.substr(begin);
}

std::string list_in_words(const std::string &body)
{
  const std::size_t start = body.find('[');
  const std::string inner = inner_pattern(body, start);
  const std::string rest = body.substr(start + inner.size());
  std::string separator = ",";
  const auto mark = rest.find("separated by <");
  if (mark != std::string::npos)
    separator = rest.substr(mark + 14, rest.find('>', mark) - mark - 14);
  std::string count;
  const auto length = rest.find("of length ");
  if (length != std::string::npos)
  {
    const std::string range = rest.substr(length + 10);
    const std::string low = trim(range.substr(0, range.find("...")));
    const std::string high =
        trim(range.substr(range.find("...") + 3, range.find('(') - range.find("...") - 3));
    if (low == high)
      count = "exactly " + low + " values";
    else if (low != "0")
      count = "at least " + low + " values";
  }
  return "a list" + (count.empty() ? "" : " of " + count) + " separated by '" + separator +
         "', each of them " + allowed_in_words(inner);
}

std::string quoted_list(const std::vector<std::string> &words)
{
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}
} // namespace

const ParameterEntry *ParameterSection::entry(const std::string &wanted) const
{
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&wanted](const ParameterEntry &e) { return e.name == wanted; });
  return found == entries.end() ? nullptr : &*found;
}

const ParameterSection *ParameterSection::section(const std::string &wanted) const
{
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&wanted](const ParameterSection &s) { return s.name == wanted; });
  return found == sections.end() ? nullptr : &*found;
}

std::vector<std::string> ParameterSection::entry_names() const
{
  std::vector<std::string> names;
  for (const auto &e : entries)
    names.push_back(e.name);
  return names;
}

std::vector<std::string> ParameterSection::section_names() const
{
  std::vector<std::string> names;
  for (const auto &s : sections)
    names.push_back(s.name);
  return names;
}

ParameterSection parameter_tree(const dealii::ParameterHandler &prm)
{
  // Of deal.II's formats only XML keeps names with a dot in one piece.
  std::stringstream stream;
  prm.print_parameters(stream,
                       static_cast<dealii::ParameterHandler::OutputStyle>(
                           dealii::ParameterHandler::XML | dealii::ParameterHandler::KeepDeclarationOrder));
  Tree tree;
  boost::property_tree::read_xml(stream, tree);
  return read_section("", tree.get_child("ParameterHandler"));
}

std::vector<std::string> choices(const std::string &pattern)
{
  std::vector<std::string> words;
  for (const std::string kind : {"[Selection ", "[MultipleSelection "})
    if (starts_with(pattern, kind))
    {
      std::istringstream stream(pattern.substr(kind.size(), pattern.size() - kind.size() - 1));
      std::string word;
      while (std::getline(stream, word, '|'))
        words.push_back(trim(word));
    }
  return words;
}

std::string allowed_in_words(const std::string &pattern)
{
  const std::string body = pattern.substr(1, pattern.size() - 2);
  if (starts_with(body, "Integer range "))
    return range_in_words("a whole number", body.substr(14), true);
  if (starts_with(body, "Integer"))
    return "a whole number";
  if (starts_with(body, "Double "))
    return range_in_words("a number", body.substr(7), false);
  if (starts_with(body, "Double"))
    return "a number";
  if (starts_with(body, "Bool"))
    return "true or false";
  if (starts_with(body, "Selection"))
    return "one of " + quoted_list(choices(pattern));
  if (starts_with(body, "MultipleSelection"))
    return "any of " + quoted_list(choices(pattern)) + ", separated by ','";
  if (starts_with(body, "List of"))
    return list_in_words(body);
  if (starts_with(body, "FileName"))
    return "the name of a file";
  if (starts_with(body, "DirectoryName"))
    return "the name of a folder";
  if (starts_with(body, "Anything"))
    return "any text";
  return body;
}

std::string parameter_path(const std::vector<std::string> &sections, const std::string &key)
{
  std::string path;
  for (const std::string &section : sections)
    path += section + "/";
  return path + key;
}
} // namespace softgrain
