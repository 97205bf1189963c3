// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/restart_check.h>
#include <softgrain/app/stage_path.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/model/state_file.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

namespace softgrain
{
namespace
{
const char *const parameters_name = "driver/parameters", *const names_name = "driver/bodies/names",
                  *const bodies_name = "driver/bodies/numbers";

/// More of them would hide the message.
constexpr std::size_t max_changes_in_message = 4;

/// The one of the parameters that may change which has to stay: the table that goes on has its columns.
const std::string has_columns = "Output/Forces on";

const std::string not_there = "(not there)", stage_names = "Stages/Names", all_stages = "Stages/";

using Parameters = std::map<std::string, std::string>;

/// Path and value of every parameter in a text that print_prm() has made.
Parameters parameters_of(const std::string &text)
{
  Parameters parameters;
  std::vector<std::string> sections;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    line = dealii::Utilities::trim(line);
    const auto equals = line.find('=');
    if (line.compare(0, 11, "subsection ") == 0)
      sections.push_back(line.substr(11));
    else if (line == "end" && !sections.empty())
      sections.pop_back();
    else if (line.compare(0, 4, "set ") == 0 && equals != std::string::npos)
    {
      std::string path;
      for (const std::string &section : sections)
        path += section + "/";
      parameters[path + dealii::Utilities::trim(line.substr(4, equals - 4))] =
          dealii::Utilities::trim(line.substr(equals + 1));
    }
  }
  return parameters;
}

/// Whether two values mean the same: 1e6 and 1000000, "0,1" and "0, 1".
bool same_value(const std::string &a, const std::string &b)
{
  if (a == b)
    return true;
  const std::vector<std::string> first = dealii::Utilities::split_string_list(a, ","),
                                 second = dealii::Utilities::split_string_list(b, ",");
  const auto same = [](const std::string &x, const std::string &y)
  {
    char *end_x = nullptr, *end_y = nullptr;
    const double number_x = std::strtod(x.c_str(), &end_x), number_y = std::strtod(y.c_str(), &end_y);
    return x == y || (!x.empty() && !y.empty() && *end_x == '\0' && *end_y == '\0' && number_x == number_y);
  };
  return first.size() == second.size() && std::equal(first.begin(), first.end(), second.begin(), same);
}

bool matches(const std::string &path, const std::string &pattern)
{
  const std::vector<std::string> names = dealii::Utilities::split_string_list(path, "/"),
                                 wanted = dealii::Utilities::split_string_list(pattern, "/");
  const bool whole_section = pattern.back() == '/';
  if (whole_section ? names.size() <= wanted.size() : names.size() != wanted.size())
    return false;
  return std::equal(wanted.begin(), wanted.end(), names.begin(),
                    [](const std::string &w, const std::string &name) { return w == "*" || w == name; });
}

std::string value_of(const Parameters &parameters, const std::string &path)
{
  const auto found = parameters.find(path);
  return found == parameters.end() ? not_there : found->second;
}

/// The parameters of all stages that had not begun, written as in changeable_in_every_model(); none when the
/// first @p n_begun names differ.
std::vector<std::string>
changeable_stages(const std::size_t n_begun, const Parameters &before, const Parameters &now)
{
  const auto names_in = [](const Parameters &parameters)
  { return dealii::Utilities::split_string_list(value_of(parameters, stage_names), ","); };
  const std::vector<std::string> old_names = names_in(before), new_names = names_in(now);
  std::vector<std::string> patterns;
  if (n_begun == 0 || new_names.size() < n_begun || old_names.size() < n_begun ||
      !std::equal(old_names.begin(), old_names.begin() + n_begun, new_names.begin()))
    return patterns;
  patterns.push_back(stage_names);
  for (const std::vector<std::string> &names : {old_names, new_names})
    for (std::size_t n = n_begun; n < names.size(); ++n)
      patterns.push_back("Stages/" + names[n] + "/");
  return patterns;
}

/// All numbers that place or shape a body; before those of its shape stands how many these are.
template <int dim>
std::vector<double> numbers_of(const BodyDescription<dim> &body)
{
  const std::vector<double> shape = body.shape->numbers();
  std::vector<double> numbers = {static_cast<double>(body.material)};
  for (unsigned int d = 0; d < dim; ++d)
    numbers.push_back(body.center[d]);
  numbers.push_back(static_cast<double>(shape.size()));
  numbers.insert(numbers.end(), shape.begin(), shape.end());
  return numbers;
}

template <int dim>
std::vector<double> numbers_of(const std::vector<BodyDescription<dim>> &bodies)
{
  std::vector<double> numbers;
  for (const BodyDescription<dim> &body : bodies)
  {
    const std::vector<double> more = numbers_of(body);
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  return numbers;
}

template <int dim>
std::string names_of(const std::vector<BodyDescription<dim>> &bodies)
{
  std::string names;
  for (const BodyDescription<dim> &body : bodies)
    names += body.name + "\n";
  return names;
}

template <int dim>
void check_bodies(const StateReader &reader, const std::vector<BodyDescription<dim>> &bodies)
{
  const std::string names = reader.read_text(names_name);
  const std::size_t n_old = std::count(names.begin(), names.end(), '\n');
  if (n_old != bodies.size())
    throw InputError("the scene has " + std::to_string(bodies.size()) +
                     " bodies and that of the checkpoint " + std::to_string(n_old) +
                     "; see 'Packing' and 'Bodies/Names'");
  if (names != names_of(bodies))
    throw InputError("the bodies have other names than those of the checkpoint; see 'Bodies/Names'");
  const std::vector<double> numbers = reader.read_doubles(bodies_name, ListSize::rows_of(1));
  std::size_t at = 0;
  for (const BodyDescription<dim> &body : bodies)
    for (const double number : numbers_of(body))
      if (at >= numbers.size() || numbers[at++] != number)
        throw InputError("body '" + body.name +
                         "' has another place, shape or material than in the checkpoint; see 'Packing/File'");
  if (at < numbers.size())
    reader.refuse(bodies_name, "it has " + std::to_string(numbers.size()) + " numbers, and the bodies have " +
                                   std::to_string(at));
}
} // namespace

template <int dim>
void save_description(StateWriter &writer, const std::string &effective_parameters, const Scene<dim> &scene)
{
  writer.write(parameters_name, effective_parameters);
  writer.write(names_name, names_of(scene.bodies));
  writer.write(bodies_name, numbers_of(scene.bodies));
}

std::vector<std::string> changeable_in_every_model()
{
  // doc/output.md lists the same. A packing may come from elsewhere: its bodies are compared one by one.
  std::vector<std::string> patterns = {"Output directory",
                                       "Threads",
                                       "Additional shared libraries",
                                       "Output/",
                                       "Stop/",
                                       "Packing/",
                                       "Walls/*/Drive",
                                       "Walls/*/Tangential velocity",
                                       "Walls/*/Shear stress",
                                       "Stages/*/Stop/"};
  const Registry<WallDrive> &drives = Registry<WallDrive>::instance();
  for (const std::string &drive : drives.names())
  {
    dealii::ParameterHandler own;
    drives.create(drive)->declare_parameters(own);
    for (const std::string &name : parameter_tree(own).entry_names())
      patterns.push_back("Walls/*/" + name);
  }
  return patterns;
}

template <int dim>
std::vector<std::string> check_description(const StateReader &reader,
                                           const std::string &effective_parameters,
                                           const Scene<dim> &scene,
                                           std::vector<std::string> changeable)
{
  const Parameters before = parameters_of(reader.read_text(parameters_name)),
                   now = parameters_of(effective_parameters);
  for (const std::string &pattern : changeable_stages(number_of_stages_begun(reader), before, now))
    changeable.push_back(pattern);
  Parameters all = before;
  all.insert(now.begin(), now.end());
  std::vector<std::string> changes;
  std::string refused, hint;
  std::size_t n_refused = 0;
  for (const auto &parameter : all)
  {
    const std::string &path = parameter.first, was = value_of(before, path), is = value_of(now, path);
    // A parameter that the checkpoint's program did not have is not set.
    if (same_value(was, is) || (was == not_there && is.empty()))
      continue;
    if (path != has_columns &&
        std::any_of(changeable.begin(), changeable.end(),
                    [&path = path](const std::string &pattern) { return matches(path, pattern); }))
    {
      // A stage that is new or gone is seen in 'Stages/Names'; its many parameters would hide other changes.
      const bool new_or_gone = was == not_there || is == not_there;
      if (!(new_or_gone && matches(path, all_stages)))
        changes.push_back("'" + path + "': " + was + " -> " + is);
      continue;
    }
    if (++n_refused <= max_changes_in_message)
      refused += (refused.empty() ? "'" : ", '") + path + "' was '" + was + "' and is '" + is + "'";
    if (matches(path, all_stages))
      hint = "; of stages only those that had not begun, and 'Stop'";
  }
  if (n_refused > max_changes_in_message)
    refused += ", and " + std::to_string(n_refused - max_changes_in_message) + " more";
  if (n_refused > 0)
    throw InputError(refused + ": a run that goes on may not change this" + hint);
  check_bodies(reader, scene.bodies);
  return changes;
}

template void save_description<2>(StateWriter &, const std::string &, const Scene<2> &);
template void save_description<3>(StateWriter &, const std::string &, const Scene<3> &);
template std::vector<std::string>
check_description<2>(const StateReader &, const std::string &, const Scene<2> &, std::vector<std::string>);
template std::vector<std::string>
check_description<3>(const StateReader &, const std::string &, const Scene<3> &, std::vector<std::string>);
} // namespace softgrain
