// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/driving/stages.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/wall_drive.h>
#include <softgrain/scene/wall_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
void Stages::declare_parameters(dealii::ParameterHandler &prm,
                                const std::vector<std::string> &names,
                                const std::vector<std::string> &walls)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Stages");
  prm.declare_entry("Names", "", List(Anything()),
                    "Names of the stages of the run, in their order; each has a subsection of its name, with "
                    "its end in 'Stop' and a subsection for every wall. Empty: there are none.");
  for (const std::string &name : names)
  {
    prm.enter_subsection(name);
    StopConditions::declare_parameters(prm);
    for (const std::string &wall : walls)
    {
      prm.enter_subsection(wall);
      WallParameters::declare_drive(prm, true);
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

void Stages::parse_parameters(dealii::ParameterHandler &prm,
                              const std::vector<std::string> &names,
                              const std::vector<std::string> &walls,
                              const StopConditions &run)
{
  const auto parse_one = [&](const std::string &name)
  {
    const WithinSection section(prm, name);
    Stage stage;
    stage.name = name;
    stage.stop.parse_parameters(prm, true);
    if (stage.stop.empty() && (name != names.back() || run.empty()))
      throw InputError("'Stages/" + name + "/Stop': the stage would never end: set one of its parameters");
    for (const std::string &wall : walls)
    {
      const WithinSection of_wall(prm, wall);
      stage.drive_names.push_back(prm.get("Drive"));
      stage.drives.push_back(WallParameters::parse_drive(prm, "Stages/" + name + "/" + wall));
    }
    list.push_back(stage);
  };
  Mistakes mistakes;
  const WithinSection section(prm, "Stages");
  for (const std::string &name : names)
    mistakes.attempt([&]() { parse_one(name); });
  mistakes.end();
}

std::string Stages::as_said_in(const Stage &stage, const std::vector<std::string> &walls, std::string message)
{
  const auto replace = [&message](const std::string &from, const std::string &to)
  {
    for (std::size_t at = 0; (at = message.find(from, at)) != std::string::npos; at += to.size())
      message.replace(at, from.size(), to);
  };
  const std::string section = "'Stages/" + stage.name + "/";
  replace("'Stop/", section + "Stop/");
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (stage.drives[w])
      replace("'Walls/" + walls[w] + "/", section + walls[w] + "/");
  return message;
}

double Stages::end_time() const
{
  double sum = 0.;
  for (const Stage &stage : list)
  {
    if (stage.stop.end_time() <= 0.)
      return 0.;
    sum += stage.stop.end_time();
  }
  return sum;
}
} // namespace softgrain
