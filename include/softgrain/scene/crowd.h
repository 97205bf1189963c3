// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_crowd_h
#define softgrain_scene_crowd_h

#include <softgrain/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
/// Bodies that are alike, in numbers.
struct BodyGroup
{
  std::string name;          ///< of the first
  std::string thinnest;      ///< the smallest, for messages: "body 'grain_3'"
  double count = 1;          ///< how many
  unsigned int material = 0; ///< index into Scene::materials
  double area = 0;           ///< of one [m^2]
  double perimeter = 0;      ///< of one, holes included [m]
  double thickness = 0;      ///< of the smallest: diameter of a disk, shorter edge of a rectangle [m]
  double short_edge = 0;     ///< of the box around the largest [m]
  bool driven = false;
};

/// One body by its size.
BodyGroup group_of(const BodyDescription<2> &body);

/// The bodies of a scene before they are made: what size, memory and time are judged by.
struct Crowd
{
  std::vector<BodyGroup> groups;

  double n_bodies() const;
  double area() const;      ///< of all [m^2]
  double thickness() const; ///< of the smallest body; 0 without bodies [m]
};

/// The bodies of @p scene, and those that its packing is expected to bring unless it is @p packed.
/// @return nothing when the packing cannot say what it will bring
/// @throw InputError when the file of a packing cannot be read
std::optional<Crowd> crowd_of(const Scene<2> &scene, bool packed);
} // namespace softgrain

#endif
