// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/check_report.h>
#include <softgrain/app/input.h>
#include <softgrain/app/machine_speed.h>
#include <softgrain/app/progress.h>
#include <softgrain/app/simulation.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/scene/contact_pairs.h>

#include <unistd.h>

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

template <int dim>
std::vector<std::string> walls_of(const Scene<dim> &scene)
{
  std::vector<std::string> names;
  for (const WallDescription<dim> &wall : scene.walls)
    names.push_back(wall.name);
  return names;
}

template <int dim>
std::vector<std::string> materials_of(const Scene<dim> &scene)
{
  std::vector<std::string> names;
  for (const MaterialDescription &material : scene.materials)
    names.push_back(material.name + " (" + material.law + ")");
  return names;
}

/// [bytes]
double memory_of_machine()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}
} // namespace

SizeReport cost_report(const RunOutline &outline, const Forecast &forecast, const double slowness)
{
  SizeReport report;
  if (forecast.n_steps > 0.)
    report = {
        {"simulated time", "about " + number_in_words(outline.duration, "s")},
        {"steps", "about " + count_in_words(forecast.n_steps)},
        {"processor time", "about " + duration_in_words(slowness * (start_seconds + forecast.seconds()))}};
  else
    report = {{"simulated time", "unknown: how the walls move does not end the run"},
              {"processor time",
               "about " + duration_in_words(1000. * slowness * forecast.step_seconds) + " for 1000 steps"}};
  report.emplace_back("memory", "about " + bytes_in_words(start_memory + forecast.memory));
  return report;
}

namespace
{
/// What falls to one of @p n ranks, beside what they wait for each other.
SizeReport cost_of_rank(const Forecast &one, const unsigned int n, const double slowness)
{
  const double memory = start_memory + one.memory;
  SizeReport report;
  const auto time = [slowness](const double seconds)
  { return "about " + duration_in_words(slowness * seconds); };
  if (one.n_steps > 0.)
    report.emplace_back("of one of " + std::to_string(n) + " ranks",
                        time(start_seconds + one.seconds()) + " of processor time, and what it waits");
  else
    report.emplace_back("of one of " + std::to_string(n) + " ranks",
                        time(1000. * one.step_seconds) + " for 1000 steps, and what it waits");
  report.emplace_back("memory of a rank", "about " + bytes_in_words(memory) +
                                              ", of all on one machine about " + bytes_in_words(n * memory));
  return report;
}

/// What a scene is made of, and when its run ends and writes.
SizeReport scene_report(const Input &input)
{
  const Scene<2> &scene = input.scene();
  const RunParameters &run = input.run();
  const bool in_space = input.dimension() == 3;
  const std::vector<std::string> walls = in_space ? walls_of(input.scene_in<3>()) : walls_of(scene),
                                 materials =
                                     in_space ? materials_of(input.scene_in<3>()) : materials_of(scene);
  const double end_time = in_space ? input.scene_in<3>().end_time : scene.end_time;

  SizeReport report = {
      {"model", run.model},
      {"materials", join(materials)},
      {"walls", join(walls)},
      {"ends at", input.stop().empty() ? "the end of the last stage" : input.stop().in_words()},
      {"results in", run.output_directory},
      {"pictures", interval_in_words(run.fields_every, end_time)},
      {"snapshots", interval_in_words(run.snapshots_every, end_time)}};
  for (std::size_t n = 0; n < input.stages().size(); ++n)
    report.emplace_back("stage " + input.stages()[n].name,
                        input.stages()[n].stop.empty() ? "until the run ends"
                                                       : "until " + input.stages()[n].stop.in_words());
  std::vector<std::string> obstacles;
  for (const ObstacleDescription<2> &obstacle : scene.obstacles)
    obstacles.push_back(obstacle.name);
  if (!obstacles.empty())
    report.emplace_back("obstacles", join(obstacles));
  report.emplace_back("friction", friction_in_words(scene));
  return report;
}
} // namespace

void print_left_out(std::ostream &out, const Input &input)
{
  for (const std::string &library : input.left_out().names)
    out << "library left out: " << library << '\n';
  for (const std::string &name : input.left_out().unknown)
    out << "unknown without the libraries: " << name << '\n';
  if (!input.left_out().unknown.empty())
    out << "all else has the right form; sizes, and whether the parts of the scene fit together, are unknown "
           "without the libraries\n";
}

void print_check_report(std::ostream &out,
                        const Input &input,
                        const std::optional<RunOutline> &outline,
                        const std::optional<Forecast> &forecast,
                        const AnyModel *model,
                        const Trial *trial,
                        const unsigned int n_ranks)
{
  SizeReport report = scene_report(input);
  const auto append = [&report](const SizeReport &lines)
  { report.insert(report.end(), lines.begin(), lines.end()); };
  if (model != nullptr)
    append(model->size_report());
  else
  {
    report.emplace_back("bodies", count_in_words(outline->crowd.n_bodies()));
    append(forecast->sizes);
  }
  std::vector<std::string> warnings;
  if (forecast)
  {
    const double slowness = trial != nullptr ? 1. : slowness_of_machine();
    if (trial != nullptr)
      report.emplace_back("trial", trial->in_words());
    append(cost_report(*outline, *forecast, slowness));
    warnings = forecast->warnings;
    if (n_ranks > 0)
    {
      const Forecast of_rank = forecast->of_rank(n_ranks);
      append(cost_of_rank(of_rank, n_ranks, slowness));
      warnings = of_rank.warnings;
    }
  }
  print_size_report(out, report);
  print_left_out(out, input);
  if (!forecast)
    return;
  if (start_memory + forecast->memory > 0.9 * memory_of_machine())
    warnings.push_back("about " + bytes_in_words(start_memory + forecast->memory) +
                       " of memory are needed, this machine has " + bytes_in_words(memory_of_machine()));
  for (const std::string &warning : warnings)
    out << "warning: " << warning << '\n';
  if (model == nullptr && trial == nullptr)
    out << "sizes are estimates; --build makes packing and bodies and says exact ones\n";
  if (trial == nullptr)
    out << "steps and times are a formula's; --try computes for some seconds and knows more\n";
}
} // namespace softgrain
