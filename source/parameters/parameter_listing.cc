// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_listing.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace softgrain
{
namespace
{
constexpr std::size_t comment_width = 100;

void print_comment(std::ostream &out, const std::string &indent, const std::string &text)
{
  std::istringstream words(text);
  std::string word, line;
  while (words >> word)
  {
    if (!line.empty() && indent.size() + line.size() + word.size() > comment_width)
    {
      out << indent << '#' << line << '\n';
      line.clear();
    }
    line += " " + word;
  }
  if (!line.empty())
    out << indent << '#' << line << '\n';
}

void print_prm_section(std::ostream &out,
                       const ParameterSection &section,
                       const bool with_documentation,
                       const std::string &indent)
{
  std::size_t width = 0;
  for (const ParameterEntry &entry : section.entries)
    width = std::max(width, entry.name.size());
  for (const ParameterEntry &entry : section.entries)
  {
    if (with_documentation)
      print_comment(out, indent, entry.documentation + " Allowed: " + allowed_in_words(entry.pattern) + ".");
    out << indent << "set " << entry.name << std::string(width - entry.name.size(), ' ') << " ="
        << (entry.value.empty() ? "" : " ") << entry.value << '\n';
    if (with_documentation)
      out << '\n';
  }
  for (const ParameterSection &child : section.sections)
  {
    out << indent << "subsection " << child.name << '\n';
    print_prm_section(out, child, with_documentation, indent + "  ");
    out << indent << "end\n" << (indent.empty() ? "\n" : "");
  }
}

nlohmann::ordered_json json_of(const ParameterSection &section)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const ParameterEntry &entry : section.entries)
    json[entry.name] = {{"value", entry.value},
                        {"default", entry.default_value},
                        {"allowed", allowed_in_words(entry.pattern)},
                        {"meaning", entry.documentation}};
  for (const ParameterSection &child : section.sections)
    json[child.name] = json_of(child);
  return json;
}

/// A bar would end the cell of a Markdown table.
std::string cell(std::string text)
{
  for (std::size_t i = text.find('|'); i != std::string::npos; i = text.find('|', i + 2))
    text.insert(i, "\\");
  return text;
}

void print_markdown_section(std::ostream &out, const ParameterSection &section, const std::string &path)
{
  if (!section.entries.empty())
  {
    out << "## " << (path.empty() ? "(top of the file)" : path) << "\n\n"
        << "| Parameter | Default | Allowed | Meaning |\n| --- | --- | --- | --- |\n";
    for (const ParameterEntry &entry : section.entries)
      out << "| " << entry.name << " | "
          << (entry.default_value.empty() ? "" : "`" + entry.default_value + "`") << " | "
          << cell(allowed_in_words(entry.pattern)) << " | " << cell(entry.documentation) << " |\n";
    out << '\n';
  }
  for (const ParameterSection &child : section.sections)
    print_markdown_section(out, child, path + (path.empty() ? "" : " / ") + child.name);
}
} // namespace

void print_prm(std::ostream &out, const ParameterSection &top, const bool with_documentation)
{
  print_prm_section(out, top, with_documentation, "");
}

void print_json(std::ostream &out, const ParameterSection &top)
{
  out << json_of(top).dump(2) << '\n';
}

void print_markdown(std::ostream &out, const ParameterSection &top)
{
  print_markdown_section(out, top, "");
}
} // namespace softgrain
