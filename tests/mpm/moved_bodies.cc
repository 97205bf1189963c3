// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that move to other ranks every few steps leave the state, to the last bit, that they leave when they
// stay; the numbers are those of one process, where none can move.
#include "scene_of.h"
#include <softgrain/base/mpi_session.h>

#include <softgrain/base/parallel.h>
#include <softgrain/base/ranks.h>

#include <cstring>
#include <iostream>

using namespace softgrain;

namespace
{
using Changes = std::vector<std::string>;

/// A state as one text.
class Bytes final : public StateWriter
{
public:
  void write(const std::string &name, const std::vector<double> &values) override
  {
    add(name, values.data(), values.size() * sizeof(double));
  }
  void write(const std::string &name, const std::vector<std::uint64_t> &values) override
  {
    add(name, values.data(), values.size() * sizeof(std::uint64_t));
  }
  void write(const std::string &name, const std::string &value) override
  {
    add(name, value.data(), value.size());
  }
  std::string all;

private:
  void add(const std::string &name, const void *const data, const std::size_t size)
  {
    all += name + ':' + std::string(static_cast<const char *>(data), size) + '\n';
  }
};

std::size_t points_here(const mpm::MpmModel &model)
{
  std::size_t sum = 0;
  for (const auto &body : model.bodies())
    sum += body.points.size();
  return sum;
}

/// Other owners each time: bodies in turn, all at the last rank, and halves that lie together.
std::vector<unsigned int>
owners(const unsigned int n_bodies, const unsigned int n_ranks, const unsigned int time)
{
  std::vector<unsigned int> result(n_bodies, n_ranks - 1);
  for (unsigned int b = 0; b < n_bodies && time % 3 != 1; ++b)
    result[b] = time % 3 == 0 ? (b + time) % n_ranks : std::min(n_ranks - 1, b * n_ranks / n_bodies);
  return result;
}

void compare(const std::string &what, const std::string &file, const Changes &changes, const unsigned int n)
{
  const Ranks ranks;
  const auto stays = shipped_scene(file, changes), moves = shipped_scene(file, changes);
  std::size_t fewest = points_here(*moves), most = fewest;
  bool same = true;
  for (unsigned int i = 0; i < n; ++i)
  {
    for (mpm::MpmModel *const model : {stays.get(), moves.get()})
    {
      StepReport report = model->advance(1.);
      model->settle(report);
    }
    if (i % 2 == 0)
      moves->move_bodies(owners(moves->bodies().size(), ranks.number(), i / 2));
    fewest = std::min(fewest, points_here(*moves));
    most = std::max(most, points_here(*moves));
    Bytes one, other;
    stays->save(one);
    moves->save(other);
    same = same && !one.all.empty() && one.all == other.all;
  }
  const double elastic = moves->energies().elastic;
  const bool all_same = !ranks.any(ranks.first() && !same), moved = ranks.any(most > fewest);
  if (ranks.first())
    std::cout << what << ": " << (all_same ? "same" : "differ") << " after each of " << n << " steps, "
              << (moved ? "points have moved" : "points lie where they lay") << ", elastic energy " << elastic
              << " J/m\n";
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  set_n_threads(1);
  const Changes coarse = {"Mesh/Cell size=6.4e-4", "Walls/top/Velocity=20"};
  const auto and_more = [](Changes changes, const Changes &more)
  {
    changes.insert(changes.end(), more.begin(), more.end());
    return changes;
  };
  compare("friction", "gallery/thirty_grains_mpm.prm", and_more(coarse, {"Contact/Friction=0.3"}), 12);
  compare("bonds", "gallery/thirty_grains_mpm.prm",
          and_more(coarse, {"Contact/Friction=0.3", "Contact/Law=bond", "Contact/Adhesion=1e4",
                            "Contact/Adhesion range=2e-5", "Contact/Healing time=1e-5"}),
          8);
  compare("plastic, new grids", "gallery/thirty_grains_mpm.prm",
          and_more(coarse, {"Materials/gel/Law=j2_plastic", "Material points/Grid update=every step"}), 8);
  compare("explicit", "gallery/thirty_grains_mpm.prm",
          and_more(coarse, {"Time/Scheme=explicit", "Time/CFL multiple=0.3", "Contact/Solver=lumped"}), 20);
  compare("in balance", "gallery/thirty_grains_quasi_static_mpm.prm",
          {"Mesh/Cell size=6.4e-4", "Packing/Number=15", "Packing/Packing fraction=0.7",
           "Packing/Upper=7.2e-3, 7.2e-3", "Walls/top/Point=0, 7.2e-3", "Walls/right/Point=7.2e-3, 0",
           "Mesh/Upper=8.2e-3, 8.2e-3", "Walls/top/Velocity=20"},
          4);
  // Rays look at the field of partners, whose rank may have changed.
  compare("rays, cells of two sizes", "gallery/two_disks.prm",
          {"Mesh/Cell size=6e-4", "Mesh/Refine near contact=1", "Material points/Shape function=linear",
           "Contact/Geometry=rays", "Contact/Friction=0.3"},
          20);
  compare("rays, cell that repeats", "gallery/simple_shear_periodic.prm",
          {"Mesh/Cell size=6.4e-4", "Contact/Geometry=rays", "Packing/Number=16",
           "Packing/Packing fraction=0.7", "Material points/Grid update=every step",
           "Walls/top/Drive=pressure", "Walls/top/Pressure=1e5", "Walls/right/Drive=pressure",
           "Walls/right/Pressure=1e5", "Walls/top/Tangential velocity=-1.5", "Stop/End time=1"},
          3);
  // Loads look at places at rest; of what is driven all ranks have the points.
  compare(
      "pushed", "gallery/two_disks.prm",
      {"Mesh/Cell size=1.2e-3", "Bodies/left/Driven=true", "Bodies/right/Body force=-2e4*(1+50*X); 1e4*y*t"},
      20);
  compare("at nodes", "gallery/two_disks.prm",
          {"Mesh/Cell size=1.2e-3", "Materials/gel/Law=linear_elastic",
           "Material points/Shape function=linear", "Material points/Fill limit=0.01",
           "Material points/Grid update=every step", "Contact/Geometry=nodes", "Contact/Nodal gap=false",
           "Contact/Solver=lumped", "Time/Scheme=newmark", "Time/Time step=1e-5"},
          30);
}
