// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/history_columns.h>
#include <softgrain/app/input.h>
#include <softgrain/app/output_folder.h>
#include <softgrain/app/restart_check.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/constitutive/load_libraries.h>
#include <softgrain/parameters/parameter_listing.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/material_parameters.h>
#include <softgrain/scene/packing_parameters.h>
#include <softgrain/scene/scene_checks.h>
#include <softgrain/scene/space_checks.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace softgrain
{
namespace
{
/// The model decides what else the file may contain, so it is looked up before anything is declared.
std::string model_of(const ParameterFile &file)
{
  const std::vector<std::string> models = Registry<ModelFactory>::instance().names();
  dealii::ParameterHandler top;
  RunParameters::declare_parameters(top, models);
  const std::string model = file.value({}, "Model", top.get("Model"));
  if (std::find(models.begin(), models.end(), model) == models.end())
  {
    const std::string near = nearest_name(model, models);
    throw InputError(file.where({}, "Model") + ": 'Model' = '" + model +
                     "' is not allowed: it must be one of " + join(models) +
                     (near.empty() ? "" : " (did you mean '" + near + "'?)"));
  }
  return model;
}
} // namespace

namespace
{
/// What is a path in a parameter file: it counts from the folder of the file.
const std::vector<std::string> &path_parameters()
{
  static const std::vector<std::string> list = {"Additional shared libraries",
                                                "Output directory",
                                                "Packing/File",
                                                "Packing/Class table",
                                                "Packing/Save to",
                                                "Primaries/Library",
                                                "Contact/Keep failed problems in"};
  return list;
}

/// Where the bodies are: what else the file may contain depends on it, too.
unsigned int dimension_of(const ParameterFile &file)
{
  const std::string dimension = file.value({}, "Dimension", "2");
  if (dimension != "2" && dimension != "3")
    throw InputError(file.where({}, "Dimension") + ": 'Dimension' = '" + dimension +
                     "' is not allowed: it must be 2 or 3");
  return dimension == "3" ? 3 : 2;
}

/// The lists that say what else the file may contain; without them nothing more can be read.
SceneNames names_of(const ParameterFile &file, Mistakes &mistakes)
{
  const auto names = [&](const std::string &section)
  {
    std::vector<std::string> found;
    if (!mistakes.attempt([&]() { found = file.names(section); }))
      mistakes.end();
    return found;
  };
  return {names("Materials"), names("Bodies"), names("Walls"), names("Stages"), names("Obstacles")};
}
} // namespace

Input::Input(const std::string &file_name,
             const std::vector<std::string> &assignments,
             const Libraries libraries)
    : Input(file_name, assignments, libraries, Mistakes())
{
}

Input::Input(const std::string &file_name,
             const std::vector<std::string> &assignments,
             const Libraries libraries,
             Mistakes mistakes)
    : file(file_name, mistakes)
{
  for (const std::string &assignment : assignments)
    mistakes.attempt([&]() { file.set(assignment); });
  file.resolve_paths(path_parameters());

  const std::vector<std::string> named =
      dealii::Utilities::split_string_list(file.value({}, "Additional shared libraries", ""));
  std::string model;
  unsigned int dimension = 2;
  SceneNames names;
  const bool known = mistakes.attempt(
      [&]()
      {
        if (libraries == Libraries::load)
          constitutive::load_libraries(named);
        else
          not_loaded.names = named;
        names = names_of(file, mistakes);
        model = model_of(file);
        dimension = dimension_of(file);
      });
  if (!known)
    mistakes.end();
  declare_all_parameters(prm, model, names, dimension);
  if (dimension == 3)
    space.emplace();
  file.apply(prm, mistakes, not_loaded.names.empty() ? nullptr : &not_loaded.unknown);
  const std::unique_ptr<ModelFactory> factory = Registry<ModelFactory>::instance().create(model);
  parse_sections(names, *factory, mistakes);
  mistakes.end();
  if (not_loaded.unknown.empty())
    check_all(*factory);
}

void Input::parse_sections(const SceneNames &names, const ModelFactory &factory, Mistakes &mistakes)
{
  Mistakes found;
  found.attempt(
      [&]()
      {
        const SceneParameters parameters(names, factory.laws(), dimension());
        if (space)
          space = parameters.parse_parameters_in_space(prm);
        else
          described_scene = parameters.parse_parameters(prm);
      });
  // A file with other mistakes need not have got as far as its end.
  const bool may_have_no_end = !names.stages.empty() || !mistakes.empty() || !found.empty();
  const bool ends =
      found.attempt([&]() { stop_conditions.parse_parameters(prm, may_have_no_end); }) &&
      found.attempt([&]()
                    { described_stages.parse_parameters(prm, names.stages, names.walls, stop_conditions); });
  described_scene.end_time = end_time();
  if (space)
    space->end_time = end_time();
  // Without an end because of another mistake: any time will do, so that there is no complaint about it.
  const double end = ends ? described_scene.end_time : 1.;
  found.attempt([&]() { run_parameters.parse_parameters(prm, file.file_name(), end); });
  for (const std::string &line : found.lines())
    if (!mistakes.concern(line))
      mistakes.add(file.located(line));
}

void Input::check_all(const ModelFactory &factory)
{
  try
  {
    Mistakes mistakes;
    if (space)
    {
      mistakes.attempt([&]() { check_scene_in_space(*space, parameter_tree(prm)); });
      mistakes.attempt([&]() { stop_conditions.check_in_space(*space); });
      mistakes.attempt([&]() { check_output_folder(run_parameters.output_directory); });
      mistakes.end();
      factory.check_in_space(*space, prm);
      described_stages.check(*space, [&](const Scene<3> &scene)
                             { check_walls_in_space(scene, parameter_tree(prm)); });
      return;
    }
    mistakes.attempt([&]() { check_scene(described_scene); });
    mistakes.attempt([&]() { check_history_columns(described_scene); });
    if (!described_scene.packing.method)
      mistakes.attempt([&]() { contact_loads(run_parameters.loads, described_scene); });
    mistakes.attempt([&]() { stop_conditions.check(described_scene); });
    mistakes.attempt([&]() { check_output_folder(run_parameters.output_directory); });
    mistakes.end();
    apply_fidelity(factory);
    factory.check(described_scene, prm);
    described_stages.check(described_scene, [&](const Scene<2> &scene) { factory.check(scene, prm); });
  }
  catch (const InputError &error)
  {
    throw_located(error);
  }
}

void Input::throw_located(const InputError &error) const
{
  Mistakes found, located;
  found.add(error);
  for (const std::string &line : found.lines())
    located.add(file.located(line));
  located.end();
  throw std::logic_error("an error without a message");
}

void Input::apply_fidelity(const ModelFactory &factory)
{
  const std::optional<Crowd> bodies = crowd();
  if (!bodies)
    return;
  for (const auto &[name, value] : factory.presets(prm.get("Fidelity"), *bodies))
  {
    const auto slash = name.find('/');
    const std::string section = name.substr(0, slash), key = name.substr(slash + 1);
    // 0 is no length of anything: it leaves the choice to 'Fidelity' too.
    if (file.value({section}, key, "0") != "0")
      continue;
    prm.enter_subsection(section);
    prm.set(key, value);
    prm.leave_subsection();
  }
}

double Input::end_time() const
{
  const double of_stages = described_stages.end_time(), of_run = stop_conditions.end_time();
  return of_stages > 0. && of_run > 0. ? std::min(of_stages, of_run) : std::max(of_stages, of_run);
}

void Input::complete_scene()
{
  if (is_complete)
    return;
  try
  {
    if (space)
      complete_scene_in_space();
    else if (described_scene.packing.method)
    {
      packing = add_packing(described_scene);
      check_scene(described_scene);
      contact_loads(run_parameters.loads, described_scene);
    }
    if (!space)
      stop_conditions.check_start(described_scene);
  }
  catch (const InputError &error)
  {
    throw_located(error);
  }
  is_complete = true;
}

void Input::complete_scene_in_space()
{
  if (!space->packing.method)
    return;
  packing_in_space = add_packing(*space);
  check_scene_in_space(*space, parameter_tree(prm));
  stop_conditions.check_in_space(*space);
}

std::unique_ptr<Model<2>> Input::create_model(const StateReader *state)
{
  complete_scene();
  try
  {
    const std::unique_ptr<ModelFactory> factory =
        Registry<ModelFactory>::instance().create(run_parameters.model);
    return state == nullptr ? factory->create(described_scene, prm)
                            : factory->create_again(described_scene, prm, *state);
  }
  catch (const InputError &error)
  {
    throw_located(error);
  }
}

std::unique_ptr<Model<3>> Input::create_model_in_space()
{
  complete_scene();
  try
  {
    return Registry<ModelFactory>::instance().create(run_parameters.model)->create_in_space(*space, prm);
  }
  catch (const InputError &error)
  {
    throw_located(error);
  }
}

void Input::save_packing(const bool overwrite) const
{
  try
  {
    if (space)
      softgrain::save_packing(space->packing, packing_in_space, overwrite);
    else
      softgrain::save_packing(described_scene.packing, packing, overwrite);
  }
  catch (const InputError &error)
  {
    throw_located(error);
  }
}

std::vector<std::string> Input::check_restart(const StateReader &checkpoint,
                                              const std::string &file_name) const
{
  std::vector<std::string> changeable = changeable_in_every_model();
  for (const std::string &pattern :
       Registry<ModelFactory>::instance().create(run_parameters.model)->changeable_on_restart())
    changeable.push_back(pattern);
  try
  {
    return space ? check_description(checkpoint, effective_parameters(), *space, changeable)
                 : check_description(checkpoint, effective_parameters(), described_scene, changeable);
  }
  catch (const InputError &error)
  {
    throw InputError("cannot go on from " + file_name + ": " + error.what());
  }
}

namespace
{
/// Paths in a file that is going to lie elsewhere. That of the results stays: nobody computes into the folder
/// of another run.
void make_paths_absolute(ParameterSection &section, const std::string &path)
{
  const std::vector<std::string> &paths = path_parameters();
  for (ParameterEntry &entry : section.entries)
  {
    const std::string name = path + entry.name;
    if (name == "Output directory" || entry.value.empty() ||
        std::find(paths.begin(), paths.end(), name) == paths.end())
      continue;
    std::string changed;
    for (const std::string &one : dealii::Utilities::split_string_list(entry.value))
    {
      std::error_code ignored;
      const bool by_name = one.find('/') == std::string::npos && name == "Additional shared libraries" &&
                           !std::filesystem::exists(one, ignored);
      changed += (changed.empty() ? "" : ", ") +
                 (by_name ? one : std::filesystem::absolute(one).lexically_normal().string());
    }
    entry.value = changed;
  }
  for (ParameterSection &below : section.sections)
    make_paths_absolute(below, path + below.name + "/");
}
} // namespace

std::string Input::effective_parameters() const
{
  std::ostringstream text;
  ParameterSection tree = parameter_tree(prm);
  make_paths_absolute(tree, "");
  print_prm(text, tree, false);
  return text.str();
}

void declare_all_parameters(dealii::ParameterHandler &prm,
                            const std::string &model,
                            const SceneNames &names,
                            const unsigned int dimension)
{
  const std::unique_ptr<ModelFactory> factory = Registry<ModelFactory>::instance().create(model);
  RunParameters::declare_parameters(prm, Registry<ModelFactory>::instance().names(), dimension);
  SceneParameters(names, factory->laws(), dimension).declare_parameters(prm);
  StopConditions::declare_parameters(prm);
  Stages::declare_parameters(prm, names.stages, names.walls);
  factory->declare_parameters(prm);
}
} // namespace softgrain
