// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/shape.h>
#include <softgrain/packing/packing_method.h>
#include <softgrain/scene/crowd.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
using dealii::numbers::PI;

double length_of(const Polygon &polygon)
{
  double sum = 0.;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += polygon[i].distance(polygon[(i + 1) % polygon.size()]);
  return sum;
}

/// Disks that are still to be packed, all of them.
BodyGroup group_of(const ExpectedGrains &disks)
{
  BodyGroup group;
  group.name = "grain_1";
  group.thinnest =
      disks.thinnest.empty() ? "the thinnest grain of 'Packing'" : "body '" + disks.thinnest + "'";
  group.count = disks.number;
  group.area = disks.mean_volume;
  group.perimeter = 2. * std::sqrt(PI * disks.mean_volume);
  group.thickness = disks.smallest;
  group.short_edge = 2. * std::sqrt(disks.mean_volume / PI);
  return group;
}
} // namespace

BodyGroup group_of(const BodyDescription<2> &body)
{
  BodyGroup group;
  group.name = body.name;
  group.thinnest = "body '" + body.name + "'";
  group.material = body.material;
  group.area = body.shape->area();
  group.driven = body.driven;
  for (const Polygon &line : body.shape->outline(0.05 * body.shape->size()))
    group.perimeter += length_of(line);
  const auto box = body.shape->bounding_box();
  // The diameter of a disk, twice the wall of a ring and twice the width of a long strip.
  const double mean_width = 4. * group.area / group.perimeter;
  group.short_edge = std::min(box.second[0] - box.first[0], box.second[1] - box.first[1]);
  group.thickness = std::min(mean_width, group.short_edge);
  return group;
}

double Crowd::n_bodies() const
{
  double sum = 0.;
  for (const BodyGroup &group : groups)
    sum += group.count;
  return sum;
}

double Crowd::area() const
{
  double sum = 0.;
  for (const BodyGroup &group : groups)
    sum += group.count * group.area;
  return sum;
}

double Crowd::thickness() const
{
  double least = 0.;
  for (const BodyGroup &group : groups)
    if (!group.driven && (least == 0. || group.thickness < least))
      least = group.thickness;
  return least;
}

std::optional<Crowd> crowd_of(const Scene<2> &scene, const bool packed)
{
  Crowd crowd;
  for (const BodyDescription<2> &body : scene.bodies)
    crowd.groups.push_back(group_of(body));
  if (!scene.packing.method || packed)
    return crowd;
  const std::optional<ExpectedGrains> grains = scene.packing.method->expected();
  if (!grains)
    return std::nullopt;
  const auto add = [&](const std::string &material, const double count)
  {
    BodyGroup group = group_of(*grains);
    group.count = count;
    for (unsigned int m = 0; m < scene.materials.size(); ++m)
      if (scene.materials[m].name == material)
        group.material = m;
    crowd.groups.push_back(group);
  };
  for (const auto &[material, count] : grains->of_material)
    add(material, count);
  if (grains->of_material.empty())
    add(scene.packing.material, grains->number);
  return crowd;
}
} // namespace softgrain
