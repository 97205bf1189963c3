// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/input.h>
#include <softgrain/app/input_estimates.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/material_parameters.h>

namespace softgrain
{
namespace
{
/// Gives some parameters other values while it lives.
class WithValues
{
public:
  WithValues(dealii::ParameterHandler &prm, const ParameterValues &values) : prm(prm)
  {
    for (const auto &[name, value] : values)
      before.emplace_back(name, set(name, value));
  }
  ~WithValues()
  {
    for (const auto &[name, value] : before)
      set(name, value);
  }
  WithValues(const WithValues &) = delete;
  WithValues &operator=(const WithValues &) = delete;

private:
  /// @return what stood there
  std::string set(const std::string &name, const std::string &value)
  {
    const auto slash = name.find('/');
    const std::string key = name.substr(slash + 1);
    prm.enter_subsection(name.substr(0, slash));
    const std::string old = prm.get(key);
    prm.set(key, value);
    prm.leave_subsection();
    return old;
  }

  dealii::ParameterHandler &prm;
  ParameterValues before;
};
} // namespace

double InputEstimates::solid_area(const Crowd &bodies) const
{
  return Registry<ModelFactory>::instance()
      .create(input.run_parameters.model)
      ->solid_area(input.described_scene, input.prm, bodies);
}

ParameterValues InputEstimates::coarser(const double factor) const
{
  const std::optional<Crowd> bodies = input.crowd();
  return bodies ? Registry<ModelFactory>::instance()
                      .create(input.run_parameters.model)
                      ->coarser(input.prm, *bodies, factor)
                : ParameterValues();
}

std::optional<Forecast> InputEstimates::forecast(const RunOutline &run, const ParameterValues &changes) const
{
  const WithValues changed(input.prm, changes);
  try
  {
    const std::unique_ptr<ModelFactory> factory =
        Registry<ModelFactory>::instance().create(input.run_parameters.model);
    std::optional<Forecast> forecast = factory->forecast(input.described_scene, input.prm, run);
    if (forecast)
      for (const std::string &line : unused_law_subsections(parameter_tree(input.prm),
                                                            input.described_scene.materials, factory->laws()))
        forecast->warnings.push_back(line);
    return forecast;
  }
  catch (const InputError &error)
  {
    input.throw_located(error);
  }
}

std::unique_ptr<Model<2>> InputEstimates::model(const ParameterValues &changes) const
{
  input.complete_scene();
  const WithValues changed(input.prm, changes);
  try
  {
    return Registry<ModelFactory>::instance()
        .create(input.run_parameters.model)
        ->create_to_look(input.described_scene, input.prm);
  }
  catch (const InputError &error)
  {
    input.throw_located(error);
  }
}
} // namespace softgrain
