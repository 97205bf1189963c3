// SPDX-License-Identifier: LGPL-2.1-or-later
// All that a parameter file may say.
#include <softgrain/app/command_line.h>
#include <softgrain/app/input.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/parameters/parameter_listing.h>

#include <algorithm>
#include <iostream>

namespace softgrain
{
void CommandLine::print_parameters() const
{
  // A name in capitals stands for each name of the user's lists. Walls and obstacles may not have the same:
  // both name columns of the history.
  const std::string obstacle = "OBSTACLE";
  const SceneNames names{{"NAME"}, {"NAME"}, {"NAME"}, {"NAME"}, {obstacle}};
  dealii::ParameterHandler prm;
  const std::vector<std::string> models = Registry<ModelFactory>::instance().names();
  if (models.empty())
    throw InputError("this program was built without any model");
  const bool has_mpm = std::find(models.begin(), models.end(), "mpm") != models.end();
  const std::string shown = !model.empty() ? model : has_mpm ? "mpm" : models.front();
  if ((dimension != 2 && dimension != 3) || (dimension == 3 && shown != "mpm" && shown != "bpm"))
    throw InputError("'--dimension' = '" + std::to_string(dimension) +
                     "' is not allowed: it must be 2 or, for the models mpm and bpm, 3");
  declare_all_parameters(prm, shown, names, dimension);
  prm.set("Model", shown);
  prm.set("Dimension", std::to_string(dimension));
  for (const std::string section : {"Materials", "Bodies", "Walls", "Obstacles", "Stages"})
  {
    prm.enter_subsection(section);
    prm.set("Names", section == "Obstacles" ? obstacle : "NAME");
    prm.leave_subsection();
  }
  // What is printed can be read as a parameter file once it has a body and an end: the wall NAME, which has
  // no default normal, and the obstacle lie where they are in nobody's way.
  prm.enter_subsection("Walls");
  prm.enter_subsection("NAME");
  prm.set("Point", dimension == 3 ? "0, 0, -1" : "0, -1");
  prm.set("Normal", dimension == 3 ? "0, 0, 1" : "0, 1");
  prm.leave_subsection();
  prm.leave_subsection();
  prm.enter_subsection("Obstacles");
  prm.enter_subsection(obstacle);
  prm.set("Points", dimension == 3 ? "0, -1; 1, -1" : "-1, -1; 1, -1");
  if (dimension == 3)
    prm.set("Thickness", "0.1");
  prm.leave_subsection();
  prm.leave_subsection();
  const ParameterSection tree = parameter_tree(prm);
  if (format == "json")
    print_json(std::cout, tree);
  else if (format == "md")
    print_markdown(std::cout, tree);
  else
    print_prm(std::cout, tree, true);
}
} // namespace softgrain
