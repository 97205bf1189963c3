// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/model/model_factory.h>

#include <deal.II/base/parameter_handler.h>

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
    return {"Time/",
            "Primaries/Library",
            "Contact/Tolerance",
            "Contact/Wall tolerance",
            "Contact/Penetration tolerance",
            "Contact/Largest penetration",
            "Contact/Maximum sweeps",
            "Contact/Algorithm",
            "Contact/Relaxation"};
  }

  LawCatalogue laws() const override
  {
    const std::vector<std::string> names = Registry<Attraction>::instance().names();
    return {names, [names](dealii::ParameterHandler &prm)
            {
              for (const std::string &name : names)
              {
                const std::unique_ptr<Attraction> law = Registry<Attraction>::instance().create(name);
                prm.enter_subsection(law->title());
                law->declare_parameters(prm);
                prm.leave_subsection();
              }
            }};
  }

  std::unique_ptr<Model<2>> create(const Scene<2> &scene, dealii::ParameterHandler &prm) const override
  {
    Settings settings;
    settings.parse_parameters(prm);
    std::vector<std::shared_ptr<const Attraction>> laws;
    std::vector<std::string> texts;
    for (const MaterialDescription &material : scene.materials)
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
      texts.push_back(text.str());
      laws.push_back(std::move(law));
    }
    return std::make_unique<BpmModel>(scene, settings, laws, texts);
  }

private:
  /// Names of the parameters of a law, in its own handler.
  static std::vector<std::string> parameter_names(const Attraction &law)
  {
    dealii::ParameterHandler own;
    law.declare_parameters(own);
    std::ostringstream text;
    own.print_parameters(text, dealii::ParameterHandler::ShortText);
    std::vector<std::string> names;
    std::istringstream lines(text.str());
    for (std::string line; std::getline(lines, line);)
    {
      const auto begin = line.find("set "), end = line.find('=');
      if (begin == std::string::npos || end == std::string::npos)
        continue;
      const std::string name = line.substr(begin + 4, end - begin - 4);
      names.push_back(name.substr(0, name.find_last_not_of(' ') + 1));
    }
    return names;
  }
};

[[maybe_unused]] const bool registered = Registry<ModelFactory>::instance().add(
    "bpm",
    "Bonded particles: aggregates of rigid disks that attract each other, with contact dynamics.",
    [] { return std::make_unique<BpmFactory>(); });
} // namespace
} // namespace softgrain::bpm
