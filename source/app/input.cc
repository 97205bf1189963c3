// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/input.h>
#include <softgrain/app/output_folder.h>
#include <softgrain/app/restart_check.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/constitutive/load_libraries.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/parameters/parameter_listing.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/material_parameters.h>
#include <softgrain/scene/packing_parameters.h>
#include <softgrain/scene/scene_checks.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <sstream>

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

Input::Input(const std::string &file_name, const std::vector<std::string> &assignments) : file(file_name)
{
  for (const std::string &assignment : assignments)
    file.set(assignment);

  constitutive::load_libraries(
      dealii::Utilities::split_string_list(file.value({}, "Additional shared libraries", "")));
  const SceneNames names{file.names("Materials"), file.names("Bodies"), file.names("Walls"),
                         file.names("Stages"), file.names("Obstacles")};
  const std::string model = model_of(file);
  declare_all_parameters(prm, model, names);
  file.apply(prm);

  try
  {
    const LawCatalogue laws = Registry<ModelFactory>::instance().create(model)->laws();
    described_scene = SceneParameters(names, laws).parse_parameters(prm);
    stop_conditions.parse_parameters(prm, !names.stages.empty());
    described_stages.parse_parameters(prm, names.stages, names.walls, stop_conditions);
    described_scene.end_time = end_time();
    run_parameters.parse_parameters(prm, file_name, described_scene.end_time);
    check_scene(described_scene);
    stop_conditions.check(described_scene);
    const std::unique_ptr<ModelFactory> factory = Registry<ModelFactory>::instance().create(model);
    apply_fidelity(*factory);
    factory->check(described_scene, prm);
    described_stages.check(described_scene, [&](const Scene<2> &scene) { factory->check(scene, prm); });
    check_output_folder(run_parameters.output_directory);
  }
  catch (const InputError &error)
  {
    throw InputError(file.located(error.what()));
  }
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

double Input::solid_area(const Crowd &bodies)
{
  return Registry<ModelFactory>::instance()
      .create(run_parameters.model)
      ->solid_area(described_scene, prm, bodies);
}

std::optional<Forecast> Input::forecast(const RunOutline &run)
{
  try
  {
    const std::unique_ptr<ModelFactory> factory =
        Registry<ModelFactory>::instance().create(run_parameters.model);
    std::optional<Forecast> forecast = factory->forecast(described_scene, prm, run);
    if (forecast)
      for (const std::string &line :
           unused_law_subsections(parameter_tree(prm), described_scene.materials, factory->laws()))
        forecast->warnings.push_back(line);
    return forecast;
  }
  catch (const InputError &error)
  {
    throw InputError(file.located(error.what()));
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
    if (described_scene.packing.method)
    {
      add_packing(described_scene);
      check_scene(described_scene);
    }
    stop_conditions.check_start(described_scene);
  }
  catch (const InputError &error)
  {
    throw InputError(file.located(error.what()));
  }
  is_complete = true;
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
    throw InputError(file.located(error.what()));
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
    return check_description(checkpoint, effective_parameters(), described_scene, changeable);
  }
  catch (const InputError &error)
  {
    throw InputError("cannot go on from " + file_name + ": " + error.what());
  }
}

std::string Input::effective_parameters() const
{
  std::ostringstream text;
  print_prm(text, parameter_tree(prm), false);
  return text.str();
}

void declare_all_parameters(dealii::ParameterHandler &prm, const std::string &model, const SceneNames &names)
{
  const std::unique_ptr<ModelFactory> factory = Registry<ModelFactory>::instance().create(model);
  RunParameters::declare_parameters(prm, Registry<ModelFactory>::instance().names());
  SceneParameters(names, factory->laws()).declare_parameters(prm);
  StopConditions::declare_parameters(prm);
  Stages::declare_parameters(prm, names.stages, names.walls);
  factory->declare_parameters(prm);
}
} // namespace softgrain
