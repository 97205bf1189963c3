// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/check_report.h>
#include <softgrain/app/input.h>
#include <softgrain/app/simulation.h>
#include <softgrain/base/nearest_name.h>

#include <cmath>
#include <ostream>
#include <sstream>

namespace softgrain
{
namespace
{
std::string interval_in_words(const double interval, const double end_time)
{
  if (interval == 0)
    return "none";
  std::string text = "every " + number_in_words(interval, "s");
  if (end_time > 0)
    text += ", " + std::to_string(static_cast<long>(std::floor(end_time / interval * (1 + 1e-9))) + 1) +
            " at most";
  return text;
}
} // namespace

void print_check_report(std::ostream &out, const Input &input, const Model<2> &model)
{
  const Scene<2> &scene = input.scene();
  const RunParameters &run = input.run();
  std::vector<std::string> walls;
  for (const WallDescription<2> &wall : scene.walls)
    walls.push_back(wall.name);
  std::vector<std::string> materials;
  for (const MaterialDescription &material : scene.materials)
    materials.push_back(material.name + " (" + material.law + ")");

  SizeReport report = {
      {"model", model.name()},
      {"materials", join(materials)},
      {"walls", join(walls)},
      {"ends at", input.stop().empty() ? "the end of the last stage" : input.stop().in_words()},
      {"results in", run.output_directory},
      {"pictures", interval_in_words(run.fields_every, scene.end_time)},
      {"snapshots", interval_in_words(run.snapshots_every, scene.end_time)}};
  for (std::size_t n = 0; n < input.stages().size(); ++n)
    report.emplace_back("stage " + input.stages()[n].name,
                        input.stages()[n].stop.empty() ? "until the run ends"
                                                       : "until " + input.stages()[n].stop.in_words());
  const SizeReport sizes = model.size_report();
  report.insert(report.end(), sizes.begin(), sizes.end());
  print_size_report(out, report);
}
} // namespace softgrain
