// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/bpm_forecast.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/bpm/space_model.h>
#include <softgrain/driving/contact_settings.h>
#include <softgrain/geometry/box.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
class BpmFactory final : public ModelFactory
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override { Settings::declare_parameters(prm); }

  std::vector<std::string> changeable_on_restart() const override
  {
    std::vector<std::string> names = ContactSettings::names();
    names.insert(names.end(), {"Time/", "Primaries/Library", "Contact/Wall tolerance", "Contact/Wall floor",
                               "Contact/Penetration tolerance", "Contact/Largest penetration"});
    return names;
  }

  LawCatalogue laws() const override
  {
    const std::vector<std::string> names = Registry<Attraction>::instance().names();
    return {names,
            [names](dealii::ParameterHandler &prm)
            {
              for (const std::string &name : names)
              {
                const std::unique_ptr<Attraction> law = Registry<Attraction>::instance().create(name);
                prm.enter_subsection(law->title());
                law->declare_parameters(prm);
                prm.leave_subsection();
              }
            },
            [](const std::string &name) { return Registry<Attraction>::instance().create(name)->title(); }};
  }

  bool works_on_ranks() const override { return true; }

  void check(const Scene<2> &scene, dealii::ParameterHandler &prm) const override { read(scene, prm); }

  ParameterValues presets(const std::string &fidelity, const Crowd &) const override
  {
    return {{"Time/Step fraction", fidelity == "draft" ? "0.2" : fidelity == "standard" ? "0.1" : "0.05"}};
  }

  ParameterValues
  coarser(dealii::ParameterHandler &prm, const Crowd &crowd, const double factor) const override
  {
    Settings settings;
    settings.parse_parameters(prm);
    // With fewer primaries a body is no solid any more.
    constexpr double fewest = 40.;
    double smallest = settings.primaries.number;
    if (smallest == 0.)
      for (const BodyGroup &body : crowd.groups)
      {
        const double own = 0.8 * body.area / settings.primaries.sizes.mean_area();
        smallest = smallest == 0. ? own : std::min(smallest, own);
      }
    const double wider = std::min(factor, std::sqrt(smallest / fewest));
    if (wider < 1.1)
      return {};
    const auto text = [](const double value)
    {
      std::ostringstream s;
      s << std::setprecision(3) << value;
      return s.str();
    };
    if (settings.primaries.number > 0)
      return {{"Primaries/Number per body", std::to_string(std::lround(smallest / (wider * wider)))}};
    ParameterValues changes;
    for (const auto &[name, value] : {std::pair("Smallest diameter", settings.primaries.sizes.smallest),
                                      {"Largest diameter", settings.primaries.sizes.largest},
                                      {"Mean diameter", settings.primaries.sizes.mean},
                                      {"Standard deviation", settings.primaries.sizes.deviation}})
      if (value > 0.)
        changes.emplace_back("Primaries/" + std::string(name), text(wider * value));
    return changes;
  }

  double solid_area(const Scene<2> &scene, dealii::ParameterHandler &prm, const Crowd &crowd) const override
  {
    return bpm::solid_area(read(scene, prm).settings, crowd);
  }

  std::optional<Forecast>
  forecast(const Scene<2> &scene, dealii::ParameterHandler &prm, const RunOutline &run) const override
  {
    const Read read_in = read(scene, prm);
    return bpm::forecast(scene, read_in.settings, read_in.laws, run);
  }

  std::unique_ptr<Model<2>> create(const Scene<2> &scene, dealii::ParameterHandler &prm) const override
  {
    const Read read_in = read(scene, prm);
    return std::make_unique<BpmModel>(scene, read_in.settings, read_in.laws, read_in.law_texts);
  }

  std::unique_ptr<Model<2>> create_to_look(const Scene<2> &scene,
                                           dealii::ParameterHandler &prm) const override
  {
    Read read_in = read(scene, prm);
    read_in.settings.primaries.keep_aggregates = false;
    return std::make_unique<BpmModel>(scene, read_in.settings, read_in.laws, read_in.law_texts);
  }

  std::unique_ptr<Model<2>>
  create_again(const Scene<2> &scene, dealii::ParameterHandler &prm, const StateReader &state) const override
  {
    const Read read_in = read(scene, prm);
    return std::make_unique<BpmModel>(scene, read_in.settings, read_in.laws, read_in.law_texts, &state);
  }

  void check_in_space(const Scene<3> &scene, dealii::ParameterHandler &prm) const override
  {
    read_in_space(scene, prm);
  }

  std::unique_ptr<Model<3>> create_in_space(const Scene<3> &scene,
                                            dealii::ParameterHandler &prm) const override
  {
    const Read read_in = read_in_space(scene, prm);
    return std::make_unique<SpaceModel>(scene, read_in.settings, read_in.laws);
  }

private:
  struct Read
  {
    Settings settings;
    std::vector<std::shared_ptr<const Attraction>> laws;
    std::vector<std::string> law_texts;
  };

  static Read read(const Scene<2> &scene, dealii::ParameterHandler &prm)
  {
    Read result;
    result.settings.parse_parameters(prm);
    check_walls(scene);
    read_laws(scene.materials, prm, result);
    return result;
  }

  static Read read_in_space(const Scene<3> &scene, dealii::ParameterHandler &prm)
  {
    Read result;
    result.settings.parse_parameters(prm);
    read_laws(scene.materials, prm, result);
    return result;
  }

  static void
  read_laws(const std::vector<MaterialDescription> &materials, dealii::ParameterHandler &prm, Read &result)
  {
    for (const MaterialDescription &material : materials)
    {
      std::shared_ptr<Attraction> law = Registry<Attraction>::instance().create(material.law);
      prm.enter_subsection("Materials");
      prm.enter_subsection(material.name);
      prm.enter_subsection(law->title());
      law->parse_parameters(prm);
      std::ostringstream text;
      text << material.law;
      for (const auto &entry : parameter_names(*law))
        text << ';' << prm.get(entry);
      prm.leave_subsection();
      prm.leave_subsection();
      prm.leave_subsection();
      result.law_texts.push_back(text.str());
      result.laws.push_back(std::move(law));
    }
  }

  /// @throw InputError for walls that this model has not
  static void check_walls(const Scene<2> &scene)
  {
    for (const WallDescription<2> &wall : scene.walls)
      if (wall.type == WallDescription<2>::Type::material_points)
        throw InputError("'Walls/" + wall.name +
                         "/Type' = 'material points' is not allowed with 'Model' = 'bpm': choose 'plane'");
    check_free_walls(scene);
    check_sliding_walls(scene);
  }

  /// Names of the parameters of a law.
  static std::vector<std::string> parameter_names(const Attraction &law)
  {
    dealii::ParameterHandler own;
    law.declare_parameters(own);
    std::vector<std::string> names = parameter_tree(own).entry_names();
    std::sort(names.begin(), names.end());
    return names;
  }
};

[[maybe_unused]] const bool registered =
    Registry<ModelFactory>::instance().add("bpm",
                                           "Bonded particles: aggregates of rigid disks, in space balls, "
                                           "that attract each other, with contact dynamics.",
                                           [] { return std::make_unique<BpmFactory>(); });
} // namespace
} // namespace softgrain::bpm
