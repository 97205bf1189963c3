// SPDX-License-Identifier: LGPL-2.1-or-later
// What is written comes back bit for bit: state files with awkward numbers and texts, and a snapshot.
#include "synthetic.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/snapshot_file.h>

#include <cstring>
#include <iostream>
#include <limits>

using namespace softgrain;

namespace
{
template <typename Item>
bool same_bits(const std::vector<Item> &a, const std::vector<Item> &b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}

void report(const std::string &what, const bool good)
{
  std::cout << what << ": " << (good ? "same" : "DIFFERENT") << '\n';
}

void state_file()
{
  using limits = std::numeric_limits<double>;
  const std::vector<double> numbers = {0.1, -0., limits::denorm_min(), limits::max(), 1 + limits::epsilon()};
  const std::vector<std::uint64_t> integers = {0, 1, ~std::uint64_t(0)};
  const std::string text = std::string("µ = 0.5\nnull:") + '\0' + "end" + '\0';
  CheckpointWriter writer(checkpoint_path("run", 42));
  writer.write("mpm/points/numbers", numbers);
  writer.write("/mpm/points/integers", integers);
  writer.write("model", text);
  writer.write("none", std::vector<double>());
  writer.write("no number", std::vector<double>{1., limits::quiet_NaN()});
  writer.write("infinite", std::vector<double>{limits::infinity()});
  writer.write("no/integers", std::vector<std::uint64_t>());
  writer.write("no/text", std::string());
  writer.commit();

  const CheckpointReader reader("run/state-000000042.h5");
  report("doubles", same_bits(numbers, reader.read_doubles("mpm/points/numbers", numbers.size())));
  report("integers", same_bits(integers, reader.read_integers("mpm/points/integers", integers.size())));
  report("text", text == reader.read_text("model"));
  report("empty", reader.read_doubles("none", 0).empty() && reader.read_integers("no/integers", 0).empty() &&
                      reader.read_text("no/text").empty());
  for (const std::string name : {"no number", "infinite"})
    try
    {
      reader.read_doubles(name, ListSize::rows_of(1));
      report(name, false);
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
  std::cout << "contains: " << reader.contains("mpm/points/numbers") << reader.contains("mpm")
            << reader.contains("mpm/absent/numbers") << reader.contains("absent") << '\n';
}

void snapshot()
{
  Snapshot<2> out = synthetic::packing(3, 3);
  out.points.extra = {{"plastic_strain", std::vector<double>(out.points.size.size(), 0.1)}};
  out.bodies[1].outline.push_back({{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}});
  out.bodies[2].outline.clear();
  out.energies = {1. / 3, 2, 3, 4};
  out.obstacles = {{"drum",
                    {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}},
                    {},
                    {0.7, 0.8},
                    1. / 3,
                    dealii::Tensor<1, 2>({1., -2.}),
                    3.},
                   {"plate", {{1., 2.}, {3., 4.}}, {}, {5., 6.}, 0., dealii::Tensor<1, 2>({0.1, 0.}), -0.2}};
  SnapshotFile file("run");
  file.append(out);
  const Snapshot<2> in = read_snapshot("run/snapshots.h5", 0);
  report("time and step", in.time == out.time && in.step == out.step);
  report("points", in.points.position == out.points.position && in.points.body == out.points.body &&
                       in.points.size == out.points.size && in.points.velocity == out.points.velocity &&
                       in.points.stress == out.points.stress &&
                       in.points.out_of_plane_stress == out.points.out_of_plane_stress &&
                       in.points.deformation_gradient == out.points.deformation_gradient);
  report("extra", in.points.extra.size() == 1 && in.points.extra[0].name == "plastic_strain" &&
                      in.points.extra[0].values == out.points.extra[0].values);
  bool bodies = in.bodies.size() == out.bodies.size(), walls = in.walls.size() == out.walls.size(),
       contacts = in.contacts.size() == out.contacts.size();
  for (std::size_t b = 0; bodies && b < in.bodies.size(); ++b)
    bodies = in.bodies[b].name == out.bodies[b].name && in.bodies[b].outline == out.bodies[b].outline &&
             in.bodies[b].area == out.bodies[b].area && in.bodies[b].mass == out.bodies[b].mass &&
             in.bodies[b].center == out.bodies[b].center &&
             in.bodies[b].mean_stress == out.bodies[b].mean_stress &&
             in.bodies[b].reference_area == out.bodies[b].reference_area;
  for (std::size_t w = 0; walls && w < in.walls.size(); ++w)
    walls = in.walls[w].name == out.walls[w].name && in.walls[w].point == out.walls[w].point &&
            in.walls[w].normal == out.walls[w].normal && in.walls[w].position == out.walls[w].position &&
            in.walls[w].normal_force == out.walls[w].normal_force;
  for (std::size_t c = 0; contacts && c < in.contacts.size(); ++c)
    contacts = in.contacts[c].body_a == out.contacts[c].body_a &&
               in.contacts[c].body_b == out.contacts[c].body_b &&
               in.contacts[c].wall == out.contacts[c].wall && in.contacts[c].place == out.contacts[c].place &&
               in.contacts[c].force == out.contacts[c].force && in.contacts[c].gap == out.contacts[c].gap &&
               in.contacts[c].length == out.contacts[c].length;
  bool obstacles = in.obstacles.size() == out.obstacles.size();
  for (std::size_t o = 0; obstacles && o < in.obstacles.size(); ++o)
    obstacles =
        in.obstacles[o].name == out.obstacles[o].name && in.obstacles[o].line == out.obstacles[o].line &&
        in.obstacles[o].pivot == out.obstacles[o].pivot && in.obstacles[o].angle == out.obstacles[o].angle &&
        in.obstacles[o].force == out.obstacles[o].force && in.obstacles[o].torque == out.obstacles[o].torque;
  report("bodies", bodies);
  report("walls", walls);
  report("obstacles", obstacles);
  report("contacts", contacts);
  report("energies", in.energies.kinetic == out.energies.kinetic &&
                         in.energies.elastic == out.energies.elastic &&
                         in.energies.dissipated == out.energies.dissipated &&
                         in.energies.external_work == out.energies.external_work);
}
} // namespace

int main()
{
  state_file();
  snapshot();
}
