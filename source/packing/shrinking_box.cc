// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/disk_solver.h>
#include <softgrain/packing/shrinking_box.h>
#include <softgrain/packing/thrown_balls.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
ShrinkingBox::ShrinkingBox(const std::vector<double> &radii, const Form &box_form, Uniform &random)
    : radius(radii)
    , form(box_form)
    , mean(std::accumulate(radii.begin(), radii.end(), 0.) / radii.size())
    , largest(*std::max_element(radii.begin(), radii.end()))
    , places(thrown_balls<2>(radii, form.half, form.periodic, random))
    , list(radii, {}, {0.2 * mean, 0., 0.5 * mean})
{
}

ShrinkingBox::Place ShrinkingBox::normal_of(const unsigned int wall)
{
  const double sign = wall % 2 == 0 ? 1. : -1.;
  return wall < 2 ? Place{sign, 0.} : Place{0., sign};
}

double ShrinkingBox::wall_gap(const unsigned int wall, const std::size_t disk) const
{
  const unsigned int d = wall / 2;
  return form.half[d] + (wall % 2 == 0 ? places[disk][d] : -places[disk][d]) - radius[disk];
}

ShrinkingBox::Place
ShrinkingBox::branch(const std::uint32_t a, const std::uint32_t b, const bool nearest) const
{
  Place result;
  for (unsigned int d = 0; d < 2; ++d)
  {
    result[d] = places[a][d] - places[b][d];
    if (nearest && form.periodic[d])
      result[d] -= 2. * form.half[d] * std::round(result[d] / (2. * form.half[d]));
  }
  return result;
}

template <class Work>
void ShrinkingBox::for_pairs_across(const double reach, const Work &work) const
{
  std::vector<std::uint32_t> first, last;
  for (unsigned int d = 0; d < 2; ++d)
  {
    if (!form.periodic[d])
      continue;
    first.clear();
    last.clear();
    const double margin = 2. * largest + reach;
    for (std::uint32_t i = 0; i < places.size(); ++i)
    {
      if (places[i][d] < margin - form.half[d])
        first.push_back(i);
      if (places[i][d] > form.half[d] - margin)
        last.push_back(i);
    }
    for (const std::uint32_t a : first)
      for (const std::uint32_t b : last)
      {
        if (a == b)
          continue;
        // Pairs across both sides belong to the first direction.
        Place apart = branch(a, b, d == 0);
        apart[d] = places[a][d] - places[b][d] + 2. * form.half[d];
        const double sum = radius[a] + radius[b] + reach;
        if (apart[0] * apart[0] + apart[1] * apart[1] < sum * sum)
          work(a, b, apart);
      }
  }
}

void ShrinkingBox::set_bodies(const double factor)
{
  const std::size_t n = places.size();
  // Across a periodic side two disks differ by the motion of the box, so there everything is seen from the
  // box.
  const double affine = co_moving() ? 0. : factor - 1.;
  bodies = {};
  for (std::size_t i = 0; i < n; ++i)
  {
    bodies.velocity.push_back({affine * places[i][0], affine * places[i][1]});
    bodies.inverse_mass.push_back(mean * mean / (radius[i] * radius[i]));
  }
  for (unsigned int w = 0; w < n_walls; ++w)
  {
    const Place normal = normal_of(w);
    const double speed = -affine * form.half[w / 2];
    bodies.velocity.push_back({speed * normal[0], speed * normal[1]});
    bodies.inverse_mass.push_back(0.);
  }
  if (form.friction == 0.)
    return;
  bodies.angular_velocity.assign(n + n_walls, 0.);
  for (std::size_t i = 0; i < n + n_walls; ++i)
    bodies.inverse_inertia.push_back(i < n ? 2. * bodies.inverse_mass[i] / (radius[i] * radius[i]) : 0.);
}

void ShrinkingBox::set_contacts(const double factor)
{
  const std::size_t n = places.size();
  // Nothing closes more than the walls do.
  const double reach = std::max(0.1 * mean, 4. * largest_shrinkage * mean);
  // What the motion of the box adds to the velocity at which two disks part.
  const double parting = co_moving() ? factor - 1. : 0.;
  const auto add_pair = [&](const std::uint32_t a, const std::uint32_t b, const Place &apart)
  {
    const double distance = std::hypot(apart[0], apart[1]), gap = distance - radius[a] - radius[b];
    // Disks on top of each other have no direction; any one gets them apart.
    const Place normal = distance > 0. ? Place{apart[0] / distance, apart[1] / distance} : Place{1., 0.};
    if (gap < reach)
      add(a, b, normal, gap, parting * distance);
  };
  contacts = {};
  contacts.colour_start = list.colour_start();
  contacts.tile_start.push_back(0);
  for (std::size_t tile = 0; tile + 1 < list.tile_start().size(); ++tile)
  {
    for (std::uint32_t pair = list.tile_start()[tile]; pair < list.tile_start()[tile + 1]; ++pair)
      add_pair(list.a(pair), list.b(pair), branch(list.a(pair), list.b(pair), false));
    contacts.tile_start.push_back(contacts.size());
  }
  if (co_moving())
  {
    // A tile and a colour of their own: they share disks with many others.
    for_pairs_across(reach, add_pair);
    contacts.tile_start.push_back(contacts.size());
    contacts.colour_start.push_back(contacts.tile_start.size() - 1);
  }
  for (unsigned int w = 0; w < n_walls; ++w)
    for (std::size_t i = 0; i < n && is_wall(w); ++i)
      if (const double gap = wall_gap(w, i); gap < reach + (1. - factor) * form.half[w / 2])
        add(i, n + w, normal_of(w), gap, parting * (gap + radius[i]));
}

void ShrinkingBox::add(
    const std::uint32_t a, const std::uint32_t b, const Place &normal, const double gap, const double parting)
{
  contacts.a.push_back(a);
  contacts.b.push_back(b);
  contacts.normal.push_back(normal);
  contacts.gap_velocity.push_back(gap + parting);
  contacts.impulse.push_back(0.);
  if (form.friction == 0.)
    return;
  contacts.friction.push_back(form.friction);
  contacts.arm_a.push_back(radius[a]);
  contacts.arm_b.push_back(b < places.size() ? radius[b] : 0.);
  contacts.tangential_impulse.push_back(0.);
}

void ShrinkingBox::move(const double factor)
{
  const double affine = co_moving() ? factor - 1. : 0.;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      places[i][d] += bodies.velocity[i][d] + affine * places[i][d];
  for (double &edge : form.half)
    edge *= factor;
  for (Place &place : places)
    for (unsigned int d = 0; d < 2; ++d)
      if (form.periodic[d])
        place[d] -= 2. * form.half[d] * std::round(place[d] / (2. * form.half[d]));
}

double ShrinkingBox::step(const double factor)
{
  list.update(places);
  set_bodies(factor);
  set_contacts(factor);
  contact::DiskSolverSettings settings;
  settings.tolerance = 1e-3;
  settings.penetration_tolerance = 1e-4 * mean;
  settings.max_sweeps = 2000;
  contact::solve_disks(bodies, contacts, settings);
  move(factor);
  return deepest_overlap();
}

void ShrinkingBox::loosen(const double factor)
{
  for (double &edge : form.half)
    edge *= factor;
  for (Place &place : places)
    for (double &component : place)
      component *= factor;
}

void ShrinkingBox::restore(const std::vector<Place> &old_places, const double old_scale)
{
  places = old_places;
  const double factor = old_scale / form.half[0];
  for (double &edge : form.half)
    edge *= factor;
}

double ShrinkingBox::deepest_overlap() const
{
  double deepest = 0.;
  const auto look = [&](const std::uint32_t a, const std::uint32_t b, const Place &apart)
  { deepest = std::max(deepest, radius[a] + radius[b] - std::hypot(apart[0], apart[1])); };
  for (std::size_t pair = 0; pair < list.n_pairs(); ++pair)
    look(list.a(pair), list.b(pair), branch(list.a(pair), list.b(pair), false));
  if (co_moving())
    for_pairs_across(0., look);
  for (unsigned int w = 0; w < n_walls; ++w)
    for (std::size_t i = 0; i < places.size() && is_wall(w); ++i)
      deepest = std::max(deepest, -wall_gap(w, i));
  return deepest;
}
} // namespace softgrain
