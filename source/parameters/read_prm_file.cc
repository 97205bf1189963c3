// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
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
/// Reads one file line by line; a line may be continued by a backslash at its end.
class PrmReader
{
public:
  PrmReader(const std::string &file_name, const std::vector<std::string> &including)
      : file_name(file_name), including(including)
  {
    this->including.push_back(std::filesystem::weakly_canonical(file_name).string());
  }

  std::vector<ParameterAssignment> read()
  {
    std::istringstream stream(read_text_file(file_name));
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
      fail("the file ends within a line continued by '\\'");
    if (!sections.empty())
      throw InputError(file_name + ":" + std::to_string(opened_at.back()) + ": subsection '" +
                       sections.back() + "' has no 'end'");
    return assignments;
  }

private:
  [[noreturn]] void fail(const std::string &message) const { throw InputError(where() + ": " + message); }

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
      fail("'" + line + "' is not understood: a line starts with set, subsection, end or include" +
           (near.empty() ? "" : " (did you mean '" + near + "'?)"));
    }
  }

  void read_assignment(const std::string &text)
  {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      fail("'set " + text + "' has no '='");
    ParameterAssignment assignment{sections, dealii::Utilities::trim(text.substr(0, equals)),
                                   dealii::Utilities::trim(text.substr(equals + 1)), where()};
    if (assignment.key.empty())
      fail("'set " + text + "' names no parameter");
    const std::string path = parameter_path(sections, assignment.key);
    const auto [first, is_new] = set_at.emplace(path, line_number);
    if (!is_new)
      fail("'" + path + "' is set twice, first on line " + std::to_string(first->second));
    assignments.push_back(assignment);
  }

  void open_section(const std::string &name)
  {
    if (name.empty())
      fail("'subsection' needs a name");
    if (sections.size() == max_section_depth)
      fail("more than " + std::to_string(max_section_depth) + " subsections within each other");
    sections.push_back(name);
    opened_at.push_back(line_number);
    assignments.push_back({sections, "", "", where()});
  }

  void close_section()
  {
    if (sections.empty())
      fail("'end' closes no subsection");
    sections.pop_back();
    opened_at.pop_back();
  }

  /// What an included file sets can be set again by the file that includes it.
  void include(const std::string &included_name)
  {
    if (included_name.empty())
      fail("'include' needs the name of a file");
    if (!sections.empty())
      fail("'include' must stand outside of subsections");
    const std::filesystem::path path = std::filesystem::path(file_name).parent_path() / included_name;
    const std::string canonical = std::filesystem::weakly_canonical(path).string();
    if (std::find(including.begin(), including.end(), canonical) != including.end())
      fail("'" + included_name + "' includes itself");
    if (!std::filesystem::is_regular_file(path))
      fail("there is no file '" + path.string() + "' to include");
    const std::vector<ParameterAssignment> included = read_prm_file(path.string(), including);
    assignments.insert(assignments.end(), included.begin(), included.end());
  }

  const std::string file_name;
  std::vector<std::string> including;
  unsigned int line_number = 0;
  std::vector<std::string> sections;
  std::vector<unsigned int> opened_at;
  std::map<std::string, unsigned int> set_at;
  std::vector<ParameterAssignment> assignments;
};
} // namespace

std::vector<ParameterAssignment> read_prm_file(const std::string &file_name,
                                               const std::vector<std::string> &including)
{
  return PrmReader(file_name, including).read();
}
} // namespace softgrain
