// SPDX-License-Identifier: LGPL-2.1-or-later
// What points, nodes, primaries and contacts carry, one scene per feature: without friction no tangent and no
// spin, without inertia no velocity. With the argument "table" also memory, allocations of a step, and where
// time goes.
#include "count_allocations.h"

#include <softgrain/app/input.h>
#include <softgrain/model/state_file.h>

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

using namespace softgrain;

namespace
{
/// How many numbers a state keeps under every name.
class Sizes final : public StateWriter
{
public:
  void write(const std::string &name, const std::vector<double> &values) override
  {
    of[name] = values.size();
  }
  void write(const std::string &name, const std::vector<std::uint64_t> &values) override
  {
    of[name] = values.size();
  }
  void write(const std::string &, const std::string &) override {}

  /// Of all arrays whose names begin with @p start.
  std::size_t sum(const std::string &start) const
  {
    std::size_t n = 0;
    for (const auto &[name, size] : of)
      n += name.compare(0, start.size(), start) == 0 ? size : 0;
    return n;
  }

  /// Of all arrays whose names end with @p end.
  std::size_t sum_of_ends(const std::string &end) const
  {
    std::size_t n = 0;
    for (const auto &[name, size] : of)
      n += name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0 ? size
                                                                                                     : 0;
    return n;
  }

  std::map<std::string, std::size_t> of;
};

/// Bytes that have been asked for and not been given back.
std::size_t heap()
{
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// The phases that take most of the time, with their shares.
void show_phases(const std::map<std::string, double> &phases)
{
  double all = 0.;
  std::vector<std::pair<double, std::string>> sorted;
  for (const auto &[name, seconds] : phases)
    if (name != "preparation of aggregates")
    {
      all += seconds;
      sorted.emplace_back(seconds, name);
    }
  std::sort(sorted.rbegin(), sorted.rend());
  for (std::size_t i = 0; i < sorted.size() && sorted[i].first > 0.05 * all; ++i)
    std::cout << (i == 0 ? "  " : ", ") << sorted[i].second << ' '
              << static_cast<int>(100. * sorted[i].first / all + 0.5) << " %";
  std::cout << '\n';
}

struct Counted
{
  std::string name, file;
  std::vector<std::string> changes;
};

double ratio(const std::size_t numbers, const std::size_t of)
{
  return of > 0 ? static_cast<double>(numbers) / static_cast<double>(of) : 0.;
}

std::size_t n_pairs(const Model<2> &model)
{
  for (const auto &[name, value] : model.size_report())
    if (name == "neighbour pairs")
      return std::stoul(value);
  return 0;
}

void show(const Counted &scene, const bool table)
{
  std::vector<std::string> words = {"Output directory=results", "Threads=1"};
  words.insert(words.end(), scene.changes.begin(), scene.changes.end());
  const std::size_t heap_before = heap();
  Input input(SOFTGRAIN_SOURCE_DIR "/parameters/" + scene.file, words);
  const std::unique_ptr<Model<2>> model = input.create_model();
  constexpr unsigned int n_steps = 20, n_counted = 4;
  unsigned long before = 0;
  for (unsigned int step = 0; step < n_steps; ++step)
  {
    if (step + n_counted == n_steps)
      before = n_allocations;
    StepReport report = model->advance(1.);
    model->settle(report);
  }
  const unsigned long allocations = (n_allocations - before) / n_counted;
  Sizes state;
  model->save(state);
  const std::size_t n = model->n_points();
  std::cout << scene.name << ": doubles per point ";
  if (model->name() == "mpm")
    std::cout << ratio(state.sum("mpm/points/"), n) << ", of them velocity "
              << ratio(state.of["mpm/points/velocity"], n) << "; of a node velocity "
              << ratio(2 * state.sum_of_ends("/nodes/velocity"), state.sum_of_ends("/nodes/displacement"))
              << "; components of a contact "
              << ratio(state.of["mpm/contact/impulses"], state.of["mpm/contact/keys"]) << '\n';
  else
    std::cout << ratio(state.of["bpm/position"] + state.of["bpm/velocity"] + state.of["bpm/radius"] +
                           state.of["bpm/angular_velocity"],
                       n)
              << ", of them spin " << ratio(state.of["bpm/angular_velocity"], n) << "; components of a pair "
              << ratio(state.of["bpm/neighbours/memory"], n_pairs(*model)) << '\n';
  if (table)
  {
    std::cout << "  points " << n << ", allocations of a step " << allocations << ", memory of a point "
              << (heap() - heap_before) / n << " bytes\n";
    show_phases(model->phases());
  }
}
} // namespace

int main(const int argc, char **)
{
  const std::string disks = "gallery/two_disks.prm", grains = "gallery/thirty_grains_mpm.prm",
                    still = "gallery/thirty_grains_quasi_static_mpm.prm",
                    bonded = "gallery/thirty_grains_bpm.prm";
  std::vector<std::string> few = {"Packing/Number=6", "Packing/Packing fraction=0.6", "Walls/top/Velocity=20",
                                  "Stop/Packing fraction=0"},
                           rough = {"Packing/Number=6", "Packing/Packing fraction=0.6",
                                    "Walls/top/Velocity=20", "Stop/Packing fraction=0",
                                    "Contact/Friction=0.5"};
  std::vector<std::string> primaries = few, rough_primaries = rough;
  for (auto *changes : {&primaries, &rough_primaries})
    changes->insert(changes->end(), {"Primaries/Smallest diameter=4e-4", "Primaries/Largest diameter=6e-4"});
  for (auto *changes : {&few, &rough})
    changes->push_back("Mesh/Cell size=6.4e-4");
  std::vector<std::string> rolling_primaries = rough_primaries, newmark = few;
  rolling_primaries.push_back("Contact/Rolling resistance=0.1");
  newmark.push_back("Time/Scheme=newmark");
  std::vector<std::string> slow = few, slow_rough = rough;
  for (auto *changes : {&slow, &slow_rough})
    changes->push_back("Walls/top/Velocity=5");
  const std::vector<Counted> scenes = {{"one body, no contact", "verification/bar_period.prm", {}},
                                       {"one body between plates", "verification/line_contact.prm", {}},
                                       {"two bodies", disks, {"Bodies/left/Center=-5.001e-3, 0"}},
                                       {"grains, no friction", grains, few},
                                       {"grains, friction", grains, rough},
                                       {"grains, newmark", grains, newmark},
                                       {"grains without inertia", still, slow},
                                       {"grains without inertia, friction", still, slow_rough},
                                       {"bonded grains, no friction", bonded, primaries},
                                       {"bonded grains, friction", bonded, rough_primaries},
                                       {"bonded grains, rolling resistance", bonded, rolling_primaries}};
  for (const Counted &scene : scenes)
    show(scene, argc > 1);
}
