// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/driving/contact_settings.h>
#include <softgrain/driving/wall.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/mpm/body/refinement.h>
#include <softgrain/mpm/model/capabilities.h>
#include <softgrain/mpm/model/mpm_forecast.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/mpm/model/unused_settings.h>
#include <softgrain/parameters/within_section.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
class MpmFactory final : public ModelFactory
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override { Settings::declare_parameters(prm); }

  std::vector<std::string> changeable_on_restart() const override
  {
    std::vector<std::string> names = ContactSettings::names();
    names.insert(names.end(), {"Time/Time step", "Time/CFL multiple", "Time/Wall way", "Time/Smallest step",
                               "Newton/", "Quasi-static/", "Linear solver/",
                               "Contact/Keep failed problems in", "Contact/Largest penetration"});
    return names;
  }

  bool works_on_ranks() const override { return true; }
  bool works_on_ranks_in_space() const override { return true; }

  LawCatalogue laws() const override
  {
    // The first is that of a material whose file names none, and must not depend on which laws there are.
    std::vector<std::string> names = constitutive::law_names();
    const auto standard = std::find(names.begin(), names.end(), "neo_hookean");
    std::rotate(names.begin(), standard, standard + (standard != names.end()));
    return {names, &constitutive::declare_all_laws, &constitutive::law_title};
  }

  void check(const Scene<2> &scene, dealii::ParameterHandler &prm) const override { read(scene, prm); }

  ParameterValues presets(const std::string &fidelity, const Crowd &crowd) const override
  {
    // Cells across the smallest body, by the studies: one body needs more, because its contacts count.
    const bool alone = crowd.n_bodies() < 1.5;
    const double cells = fidelity == "draft"      ? (alone ? 12. : 3.)
                         : fidelity == "standard" ? (alone ? 24. : 4.5)
                                                  : (alone ? 48. : 8.);
    std::vector<std::pair<std::string, std::string>> list;
    if (crowd.thickness() > 0.)
    {
      std::ostringstream cell;
      cell << std::setprecision(3) << crowd.thickness() / cells;
      list.emplace_back("Mesh/Cell size", cell.str());
    }
    if (fidelity == "reference")
      list.emplace_back("Time/CFL multiple", "4");
    return list;
  }

  ParameterValues
  coarser(dealii::ParameterHandler &prm, const Crowd &crowd, const double factor) const override
  {
    prm.enter_subsection("Mesh");
    const double cell = prm.get_double("Cell size");
    prm.leave_subsection();
    // With fewer cells than that bodies lie in each other before they have been pressed far.
    const double fewest = crowd.n_bodies() < 1.5 ? 10. : 3.;
    const double largest = crowd.thickness() > 0. ? crowd.thickness() / fewest : cell;
    if (std::min(factor * cell, largest) < 1.1 * cell)
      return {};
    std::ostringstream text;
    text << std::setprecision(3) << std::min(factor * cell, largest);
    return {{"Mesh/Cell size", text.str()}};
  }

  std::optional<Forecast>
  forecast(const Scene<2> &scene, dealii::ParameterHandler &prm, const RunOutline &run) const override
  {
    const auto [settings, laws] = read(scene, prm);
    Forecast result = mpm::forecast(scene, settings, laws, run);
    for (const std::string &line : unused_settings(parameter_tree(prm), settings))
      result.warnings.push_back(line);
    return result;
  }

  std::unique_ptr<Model<2>> create(const Scene<2> &scene, dealii::ParameterHandler &prm) const override
  {
    auto [settings, laws] = read(scene, prm);
    return std::make_unique<MpmModel>(scene, settings, std::move(laws));
  }

  void check_in_space(const Scene<3> &scene, dealii::ParameterHandler &prm) const override
  {
    read_in_space(scene, prm);
  }

  std::unique_ptr<Model<3>> create_in_space(const Scene<3> &scene,
                                            dealii::ParameterHandler &prm) const override
  {
    const auto [settings, laws] = read_in_space(scene, prm);
    return std::make_unique<SpaceModel>(scene, settings, laws);
  }

private:
  /// Settings and the laws of the materials.
  static std::pair<Settings, SpaceModel::Laws> read_in_space(const Scene<3> &scene,
                                                             dealii::ParameterHandler &prm)
  {
    Settings settings;
    settings.parse_parameters(prm, 3);
    check_capabilities(scene, settings);
    if (settings.scheme.ends_in_balance() && settings.chosen_way && scene.walls.empty() &&
        scene.obstacles.empty())
      throw InputError(
          "'Time/Time step' = '0' is not allowed with 'Dimension' = '3' and 'Time/Scheme' = 'quasi_static': "
          "set it, or 'Time/Wall way', greater than 0");
    SpaceModel::Laws laws;
    for (const MaterialDescription &material : scene.materials)
    {
      laws.push_back(law_of<3>(material, prm));
      if (!laws.back()->symmetric_tangent())
        throw InputError("'Materials/" + material.name + "/Law' = '" + material.law +
                         "' is not allowed with 'Dimension' = '3': its tangent must be symmetric");
    }
    return {settings, laws};
  }

  template <int dim>
  static std::shared_ptr<const constitutive::Law<dim>> law_of(const MaterialDescription &material,
                                                              dealii::ParameterHandler &prm)
  {
    const WithinSection materials(prm, "Materials"), own(prm, material.name);
    try
    {
      return constitutive::create_law<dim>(material.law, prm);
    }
    catch (const InputError &error)
    {
      throw InputError("'Materials/" + material.name + "': " + error.what());
    }
  }

  using Laws = std::vector<std::shared_ptr<const constitutive::Law<2>>>;

  static std::pair<Settings, Laws> read(const Scene<2> &scene, dealii::ParameterHandler &prm)
  {
    Settings settings;
    settings.parse_parameters(prm);
    check_free_walls(scene);
    check_sliding_walls(scene);
    check_capabilities(scene, settings);
    // What a packing will put where is not known before it is made.
    if (settings.refine_near_contact > 0 && !scene.packing.method)
      check_refinement(scene, settings);
    Laws laws;
    for (const MaterialDescription &material : scene.materials)
    {
      laws.push_back(law_of<2>(material, prm));
      if (settings.scheme.solves_equations() && !laws.back()->symmetric_tangent())
        throw InputError("'Materials/" + material.name + "/Law' = '" + material.law +
                         "' is not allowed with 'Time/Scheme' = '" + settings.scheme.name +
                         "': its tangent is not symmetric, and the linear solvers need that it is; choose "
                         "'Time/Scheme' = 'explicit'");
    }
    return {settings, laws};
  }
};

[[maybe_unused]] const bool registered = Registry<ModelFactory>::instance().add(
    "mpm",
    "Implicit or explicit material point method with contact dynamics.",
    [] { return std::make_unique<MpmFactory>(); });
} // namespace
} // namespace softgrain::mpm
