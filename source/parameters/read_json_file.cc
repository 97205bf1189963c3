// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/parameters/parameter_file.h>
#include <softgrain/parameters/parameter_tree.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace softgrain
{
namespace
{
/// Walks over a text and counts lines, so that the reader knows where it is.
class CountingIterator
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char *;
  using reference = const char &;

  CountingIterator(const char *place, unsigned int *line) : place(place), line(line) {}

  reference operator*() const { return *place; }
  CountingIterator &operator++()
  {
    if (*place == '\n')
      ++*line;
    ++place;
    return *this;
  }
  bool operator==(const CountingIterator &other) const { return place == other.place; }
  bool operator!=(const CountingIterator &other) const { return place != other.place; }

private:
  const char *place;
  unsigned int *line;
};

/// Turns JSON events into assignments.
class JsonReader : public nlohmann::json_sax<nlohmann::json>
{
public:
  JsonReader(const std::string &file_name, const std::string &text, Mistakes &mistakes)
      : file_name(file_name), text(text), mistakes(mistakes)
  {
  }

  std::vector<ParameterAssignment> read()
  {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
      fail("the file is empty; parameters in JSON are an object, { ... }");
    const char *begin = text.data();
    nlohmann::json::sax_parse(CountingIterator(begin, &line), CountingIterator(begin + text.size(), &line),
                              this);
    return assignments;
  }

  bool null() override
  {
    if (!started)
      fail("the file must hold one object { ... }");
    complain("'" + parameter_path(sections, current_key) + "' = null: null is not a value");
    return true;
  }
  bool boolean(const bool value) override { return scalar(value ? "true" : "false"); }
  bool number_integer(const number_integer_t value) override { return scalar(std::to_string(value)); }
  bool number_unsigned(const number_unsigned_t value) override { return scalar(std::to_string(value)); }
  bool number_float(const number_float_t, const string_t &written) override { return scalar(written); }
  bool string(string_t &value) override { return scalar(value); }
  bool binary(binary_t &) override { fail("binary data is not a value"); }

  bool start_object(std::size_t) override
  {
    if (list_depth > 0)
      fail("a list cannot hold a section");
    if (started)
    {
      if (sections.size() == max_section_depth)
        fail("more than " + std::to_string(max_section_depth) + " sections within each other");
      sections.push_back(current_key);
      section_begins.push_back({assignments.size(), where(key_line)});
      assignments.push_back({sections, "", "", where(line)});
    }
    started = true;
    return true;
  }

  bool key(string_t &name) override
  {
    current_key = name;
    key_line = line;
    if (name.empty())
      fail("a parameter needs a name");
    const std::string path = parameter_path(sections, name);
    const auto [first, is_new] = set_at.emplace(path, line);
    if (!is_new)
      complain("'" + path + "' is set twice, first on line " + std::to_string(first->second));
    return true;
  }

  bool end_object() override
  {
    if (sections.empty())
      return true;
    const auto [first, at] = section_begins.back();
    section_begins.pop_back();
    const auto begin = assignments.begin() + first;
    const auto value = std::find_if(begin, assignments.end(),
                                    [this](const ParameterAssignment &a)
                                    { return a.key == "value" && a.sections == sections; });
    const std::string name = sections.back();
    if (value == assignments.end())
      sections.pop_back();
    else
    {
      check_described_parameter(begin, assignments.end());
      const std::string text = value->value;
      assignments.erase(begin, assignments.end());
      sections.pop_back();
      assignments.push_back({sections, name, text, at});
    }
    return true;
  }

  bool start_array(std::size_t) override
  {
    if (!started)
      fail("the file must hold one object { ... }");
    if (list_depth == 0)
      list.clear();
    else if (list_depth == 1 && !list.empty())
      list += "; ";
    else if (list_depth == 2)
      fail("lists of lists of lists have no meaning here");
    ++list_depth;
    first_in_list = true;
    return true;
  }

  bool end_array() override
  {
    if (--list_depth == 0)
      store(list);
    return true;
  }

  bool parse_error(std::size_t, const std::string &, const nlohmann::detail::exception &error) override
  {
    const std::string message = error.what();
    const auto detail = message.find(": ");
    fail("not valid JSON: " + (detail == std::string::npos ? message : message.substr(detail + 2)));
  }

private:
  [[noreturn]] void fail(const std::string &message) const { throw InputError(where(line) + ": " + message); }

  /// What is wrong but does not change what the rest means.
  void complain(const std::string &message)
  {
    mistakes.add(where(line) + ": " + message, parameter_path(sections, current_key));
  }

  std::string where(const unsigned int at) const { return file_name + ":" + std::to_string(at); }

  bool scalar(const std::string &value)
  {
    if (!started)
      fail("the file must hold one object { ... }");
    if (list_depth == 0)
      store(value);
    else
    {
      list += (first_in_list ? "" : ", ") + value;
      first_in_list = false;
    }
    return true;
  }

  /// {"value": …, "default": …} is one parameter with its description, as `softgrain parameters --format
  /// json` and deal.II print it. What describes it is not read.
  void check_described_parameter(const std::vector<ParameterAssignment>::const_iterator begin,
                                 const std::vector<ParameterAssignment>::const_iterator end) const
  {
    static const std::set<std::string> described = {"",
                                                    "value",
                                                    "default",
                                                    "allowed",
                                                    "meaning",
                                                    "default_value",
                                                    "documentation",
                                                    "pattern",
                                                    "pattern_description"};
    for (auto entry = begin; entry != end; ++entry)
      if (entry->sections != sections || described.count(entry->key) == 0)
        throw InputError(entry->where + ": '" + parameter_path(entry->sections, entry->key) +
                         "' cannot stand beside a \"value\"; allowed are default, allowed and meaning");
  }

  void store(const std::string &value)
  {
    assignments.push_back({sections, current_key, value, where(key_line)});
  }

  const std::string file_name;
  const std::string text;
  Mistakes &mistakes;
  unsigned int line = 1;
  unsigned int key_line = 1;
  bool started = false;
  unsigned int list_depth = 0;
  bool first_in_list = true;
  std::string list;
  std::string current_key;
  std::vector<std::string> sections;
  std::vector<std::pair<std::size_t, std::string>> section_begins; ///< first assignment and place
  std::map<std::string, unsigned int> set_at;
  std::vector<ParameterAssignment> assignments;
};
} // namespace

std::vector<ParameterAssignment> read_json_file(const std::string &file_name, Mistakes &mistakes)
{
  std::vector<ParameterAssignment> assignments;
  if (!mistakes.attempt([&]()
                        { assignments = JsonReader(file_name, read_text_file(file_name), mistakes).read(); }))
    mistakes.end();
  return assignments;
}
} // namespace softgrain
