// SPDX-License-Identifier: LGPL-2.1-or-later
// A snapshot in space comes back bit for bit, from snapshots.h5 and from a checkpoint; one of the plane is
// not taken for one of space; surfaces whose offsets do not fit are refused.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/hdf5_reader.h>
#include <softgrain/output/hdf5_writer.h>
#include <softgrain/output/snapshot_file.h>
#include <softgrain/output/snapshot_layout.h>

#include <iostream>

using namespace softgrain;

namespace
{
dealii::Tensor<1, 3> vector(const double x, const double y, const double z)
{
  return dealii::Tensor<1, 3>({x, y, z});
}

/// Numbers that are all different.
template <class Tensor>
Tensor filled(double next)
{
  Tensor tensor;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      tensor[i][j] = next *= -1.1;
  return tensor;
}

Snapshot<3> some_snapshot()
{
  Snapshot<3> snapshot;
  snapshot.time = 1. / 3.;
  snapshot.step = 7;
  snapshot.energies = {1. / 3., 2., 3., 4.};
  for (unsigned int b = 0; b < 2; ++b)
  {
    BodyState<3> body;
    body.name = "grain_" + std::to_string(b + 1);
    for (unsigned int v = 0; v < 4 + b; ++v)
      body.outline.resize(1), body.outline[0].emplace_back(0.1 * v, b, v * v / 7.);
    body.triangles = {{{0, 1, 2}}, {{3, 2, 1}}};
    body.area = 0.1 + b;
    body.reference_area = 0.2 + b;
    body.mass = 3. + b;
    body.center = dealii::Point<3>(b, 1. / 3., 5.);
    body.mean_stress = filled<dealii::SymmetricTensor<2, 3>>(1. + b);
    snapshot.bodies.push_back(body);
  }
  for (unsigned int p = 0; p < 5; ++p)
  {
    snapshot.points.position.emplace_back(0.1 * p, 0.2, 0.3 / (p + 1.));
    snapshot.points.body.push_back(p % 2);
    snapshot.points.size.push_back(0.1 * p);
    snapshot.points.velocity.push_back(vector(1., 0.1 * p, 3.));
    snapshot.points.stress.push_back(filled<dealii::SymmetricTensor<2, 3>>(2. + p));
    snapshot.points.deformation_gradient.push_back(filled<dealii::Tensor<2, 3>>(3. + p));
  }
  ContactState<3> contact;
  contact.body_a = 0;
  contact.body_b = 1;
  contact.place = dealii::Point<3>(1., 2., 1. / 3.);
  contact.normal = vector(0.6, 0., 0.8);
  contact.force = vector(6., 0.1, 8.);
  contact.gap = -1e-7;
  snapshot.contacts.push_back(contact);
  contact.body_b = ContactState<3>::not_a_body;
  contact.wall = 0;
  snapshot.contacts.push_back(contact);
  WallState<3> wall;
  wall.name = "bottom";
  wall.point = dealii::Point<3>(0., 0., -1.);
  wall.normal = vector(0., 0., 1.);
  wall.position = -1.;
  wall.velocity = 0.1;
  wall.normal_force = 5.;
  snapshot.walls.push_back(wall);
  snapshot.obstacles = {{"plate",
                         {{0., 0., 1.}, {2., 0., 1. / 3.}, {0., 2., 1.}},
                         {{{0, 1, 2}}},
                         {0.1, 0.2, 0.3},
                         1. / 3.,
                         vector(1., -2., 3.),
                         0.7},
                        {"empty", {}, {}, {}, 0., vector(0., 0., 0.), 0.}};
  return snapshot;
}

void compare(const char *what, const Snapshot<3> &in, const Snapshot<3> &out)
{
  bool same = in.time == out.time && in.step == out.step && in.energies.kinetic == out.energies.kinetic &&
              in.energies.external_work == out.energies.external_work;
  same = same && in.points.position == out.points.position && in.points.body == out.points.body &&
         in.points.size == out.points.size && in.points.velocity == out.points.velocity &&
         in.points.stress == out.points.stress &&
         in.points.deformation_gradient == out.points.deformation_gradient;
  same = same && in.bodies.size() == out.bodies.size();
  for (std::size_t b = 0; same && b < in.bodies.size(); ++b)
  {
    const BodyState<3> &one = in.bodies[b], &other = out.bodies[b];
    same = one.name == other.name && one.outline == other.outline && one.triangles == other.triangles &&
           one.area == other.area && one.reference_area == other.reference_area && one.mass == other.mass &&
           one.center == other.center && one.mean_stress == other.mean_stress;
  }
  same = same && in.contacts.size() == out.contacts.size();
  for (std::size_t c = 0; same && c < in.contacts.size(); ++c)
  {
    const ContactState<3> &one = in.contacts[c], &other = out.contacts[c];
    same = one.body_a == other.body_a && one.body_b == other.body_b && one.wall == other.wall &&
           one.place == other.place && one.normal == other.normal && one.force == other.force &&
           one.gap == other.gap;
  }
  same = same && in.walls.size() == 1 && in.walls[0].name == "bottom" &&
         in.walls[0].point == out.walls[0].point && in.walls[0].normal == out.walls[0].normal &&
         in.walls[0].position == -1. && in.walls[0].velocity == 0.1 && in.walls[0].normal_force == 5.;
  same = same && in.obstacles.size() == out.obstacles.size();
  for (std::size_t o = 0; same && o < in.obstacles.size(); ++o)
  {
    const ObstacleState<3> &one = in.obstacles[o], &other = out.obstacles[o];
    same = one.name == other.name && one.line == other.line && one.triangles == other.triangles &&
           one.pivot == other.pivot && one.angle == other.angle && one.force == other.force &&
           one.torque == other.torque;
  }
  std::cout << what << ": " << (same ? "same" : "DIFFERENT") << '\n';
}

template <typename F>
void refused(const F &work)
{
  try
  {
    work();
    std::cout << "NOT REFUSED\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  const Snapshot<3> out = some_snapshot();
  SnapshotFile file("run");
  file.append(out);
  std::cout << "dimension " << dimension_of_snapshots("run/snapshots.h5") << '\n';
  compare("snapshots.h5", read_snapshot<3>("run/snapshots.h5", 0), out);
  CheckpointWriter writer("run/state-000000001.h5");
  writer.write_snapshot("driver/snapshot", out);
  writer.commit();
  compare("checkpoint", CheckpointReader("run/state-000000001.h5").read_snapshot<3>("driver/snapshot"), out);

  refused([] { read_snapshot<2>("run/snapshots.h5", 0); });
  SnapshotFile("plane").append(Snapshot<2>());
  std::cout << "dimension " << dimension_of_snapshots("plane/snapshots.h5") << '\n';
  refused([] { read_snapshot<3>("plane/snapshots.h5", 0); });
  Snapshot<3> beyond = out;
  beyond.bodies[0].triangles[0][1] = 4; // there are four vertices
  Hdf5Writer made("beyond.h5");
  write_snapshot(made, beyond, true, "here/");
  made.close();
  refused([] { read_snapshot_group<3>(Hdf5Reader("beyond.h5"), "here/"); });
}
