// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/parameters/parameter_file.h>
#include <softgrain/parameters/parameter_tree.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

namespace softgrain
{
namespace
{
/// The files on the way to the one that is read, and what all of them have in common.
struct Includes
{
  std::vector<std::string> way;
  unsigned int number = 0; ///< files that were included
  bool lost = false;       ///< whether it is unknown what the rest means
};

/// What is thrown when nothing that follows can be read; the mistake has been kept.
struct Lost
{
};

/// Reads one file line by line; a line may be continued by a backslash at its end.
class PrmReader
{
public:
  PrmReader(const std::string &file_name, Includes &includes, Mistakes &mistakes)
      : file_name(file_name), includes(includes), mistakes(mistakes)
  {
  }

  /// What the included files set, in their order, then what this one sets itself: the last counts.
  std::vector<ParameterAssignment> read()
  {
    std::istringstream stream(read_text_file(file_name));
    std::error_code error; // a name that is too long: reading the file tells
    includes.way.push_back(std::filesystem::weakly_canonical(file_name, error).string());
    std::string line, continued;
    for (line_number = 1; std::getline(stream, line); ++line_number)
    {
      line = dealii::Utilities::trim(continued + line.substr(0, line.find('#')));
      continued.clear();
      if (!line.empty() && line.back() == '\\')
        continued = line.substr(0, line.size() - 1);
      else if (!line.empty())
        read_line(line);
    }
    if (!continued.empty())
      lose("the file ends within a line continued by '\\'");
    if (!sections.empty())
    {
      line_number = opened_at.back();
      lose("subsection '" + sections.back() + "' has no 'end'");
    }
    includes.way.pop_back();
    included.insert(included.end(), assignments.begin(), assignments.end());
    return included;
  }

private:
  /// A line that says nothing; the others still mean what they say.
  void complain(const std::string &message)
  {
    mistakes.add(where() + ": " + message, parameter_path(sections, ""));
  }

  /// Gives up: nobody knows what belongs to which section, or something is missing as a whole.
  void lose(const std::string &message)
  {
    complain(message);
    includes.lost = true;
  }

  std::string where() const { return file_name + ":" + std::to_string(line_number); }

  void read_line(const std::string &line)
  {
    const auto blank = line.find_first_of(" \t");
    const std::string word = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : dealii::Utilities::trim(line.substr(blank));
    if (word == "set")
      read_assignment(rest);
    else if (word == "subsection")
      open_section(rest);
    else if (line == "end")
      close_section();
    else if (word == "include")
      include(rest);
    else
    {
      const std::string near = nearest_name(word, {"set", "subsection", "end", "include"});
      complain("'" + line + "' is not understood: a line starts with set, subsection, end or include" +
               (near.empty() ? "" : " (did you mean '" + near + "'?)"));
      // So that the lines that follow are not taken for others than they are.
      if (near == "subsection" && !rest.empty())
        open_section(rest);
      else if (near == "end" && rest.empty())
        close_section();
      else if (near == "set" && rest.find('=') != std::string::npos)
        read_assignment(rest);
      else if (near == "include")
        includes.lost = true;
    }
  }

  void read_assignment(const std::string &text)
  {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      return complain("'set " + text + "' has no '='");
    ParameterAssignment assignment{sections, dealii::Utilities::trim(text.substr(0, equals)),
                                   dealii::Utilities::trim(text.substr(equals + 1)), where()};
    if (assignment.key.empty())
      return complain("'set " + text + "' names no parameter");
    const std::string path = parameter_path(sections, assignment.key);
    const auto [first, is_new] = set_at.emplace(path, line_number);
    if (!is_new)
      return complain("'" + path + "' is set twice, first on line " + std::to_string(first->second));
    assignments.push_back(assignment);
  }

  void open_section(const std::string &name)
  {
    if (name.empty())
      lose("'subsection' needs a name");
    if (sections.size() == max_section_depth)
      throw_lost("more than " + std::to_string(max_section_depth) + " subsections within each other");
    sections.push_back(name);
    opened_at.push_back(line_number);
    assignments.push_back({sections, "", "", where()});
  }

  void close_section()
  {
    if (sections.empty())
      return lose("'end' closes no subsection");
    sections.pop_back();
    opened_at.pop_back();
  }

  void include(const std::string &included_name)
  {
    if (included_name.empty())
      return lose("'include' needs the name of a file");
    if (!sections.empty())
      return lose("'include' must stand outside of subsections");
    const std::filesystem::path path = std::filesystem::path(file_name).parent_path() / included_name;
    std::error_code error;
    const std::string canonical = std::filesystem::weakly_canonical(path, error).string();
    if (std::find(includes.way.begin(), includes.way.end(), canonical) != includes.way.end())
      return lose("'" + included_name + "' includes itself");
    if (!std::filesystem::is_regular_file(path, error))
      return lose("there is no file '" + path.string() + "' to include");
    if (includes.way.size() == max_include_depth)
      throw_lost("more than " + std::to_string(max_include_depth) + " files that include each other");
    if (++includes.number > max_includes)
      throw_lost("this is include number " + std::to_string(includes.number) + ", and " +
                 std::to_string(max_includes) + " are allowed; a file that is included twice counts twice");
    const std::vector<ParameterAssignment> found = PrmReader(path.string(), includes, mistakes).read();
    included.insert(included.end(), found.begin(), found.end());
  }

  [[noreturn]] void throw_lost(const std::string &message)
  {
    lose(message);
    throw Lost();
  }

  const std::string file_name;
  Includes &includes;
  Mistakes &mistakes;
  unsigned int line_number = 0;
  std::vector<std::string> sections;
  std::vector<unsigned int> opened_at;
  std::map<std::string, unsigned int> set_at;
  std::vector<ParameterAssignment> included, assignments;
};
} // namespace

std::vector<ParameterAssignment> read_prm_file(const std::string &file_name, Mistakes &mistakes)
{
  Includes includes;
  std::vector<ParameterAssignment> assignments;
  try
  {
    assignments = PrmReader(file_name, includes, mistakes).read();
  }
  catch (const Lost &)
  {
  }
  if (includes.lost)
    mistakes.end();
  return assignments;
}
} // namespace softgrain
