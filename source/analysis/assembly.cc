// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/assembly.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace softgrain
{
namespace
{
constexpr unsigned int none = ContactState<2>::not_a_body;

/// The row seen from the body with the smaller index.
ContactState<2> ordered(ContactState<2> row)
{
  if (row.body_b < row.body_a)
  {
    std::swap(row.body_a, row.body_b);
    row.normal *= -1.;
    row.force *= -1.;
    row.place -= row.image;
    row.image *= -1.;
  }
  return row;
}

/// How far the places of @p rows are apart along the contact.
double extent(const std::vector<ContactState<2>> &rows, const dealii::Tensor<1, 2> &normal)
{
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  for (const ContactState<2> &row : rows)
  {
    const double along = (row.place - rows[0].place) * dealii::Tensor<1, 2>({normal[1], -normal[0]});
    lower = std::min(lower, along);
    upper = std::max(upper, along);
  }
  return upper - lower;
}

BodyContact merged(const std::vector<ContactState<2>> &rows)
{
  BodyContact contact;
  contact.body_a = rows[0].body_a;
  contact.body_b = rows[0].body_b;
  contact.wall = rows[0].wall;
  dealii::Tensor<1, 2> by_length, plain;
  for (const ContactState<2> &row : rows)
  {
    contact.force += row.force;
    contact.length += row.length;
    by_length += row.length * row.normal;
    plain += row.normal;
  }
  // Normals of a rough contact may cancel; then the force is the best guess of where the partner is.
  const dealii::Tensor<1, 2> direction = by_length.norm() > 0. ? by_length
                                         : plain.norm() > 1e-9 ? plain
                                                               : contact.force;
  contact.normal = direction.norm() > 0. ? direction / direction.norm() : rows[0].normal;
  contact.normal_force = contact.force * contact.normal;
  double weight = 0.;
  dealii::Tensor<1, 2> moment, mean;
  for (const ContactState<2> &row : rows)
  {
    const double pressed = std::max(0., row.force * row.normal);
    weight += pressed;
    moment += pressed * (row.place - rows[0].place);
    mean += (row.place - rows[0].place) / static_cast<double>(rows.size());
  }
  contact.place = rows[0].place + (weight > 0. ? moment / weight : mean);
  // Disks that fit into each other's gaps touch twice on the way along a contact, and some models write a row
  // from either side: lengths then add up to more than there is room for.
  const double room = extent(rows, contact.normal) + contact.length / rows.size();
  contact.length = contact.length > 0. ? std::min(contact.length, room) : room;
  return contact;
}
} // namespace

Assembly::Assembly(const Snapshot<2> &snapshot, const MeasureContext &context)
    : snapshot(snapshot), context(context)
{
  // In a small cell that repeats a body may touch two images of another.
  std::map<std::tuple<unsigned int, unsigned int, unsigned int, double, double>, std::vector<ContactState<2>>>
      groups;
  for (const ContactState<2> &row : snapshot.contacts)
    if (row.wall != none)
    {
      groups[{row.body_a, none, row.wall, 0., 0.}].push_back(row);
      groups[{row.body_a, none, row.wall, 0., 0.}].back().body_b = none;
    }
    else if (row.body_a != row.body_b)
    {
      const ContactState<2> seen = ordered(row);
      groups[{seen.body_a, seen.body_b, none, seen.image[0], seen.image[1]}].push_back(seen);
    }
  for (const auto &group : groups)
    contacts.push_back(merged(group.second));

  const std::optional<Box<2>> size = box_of(snapshot.walls);
  const auto velocity = [&snapshot](const std::string &name)
  { return find_wall(snapshot.walls, name)->velocity; };
  if (size && size->height() > 0. && size->width() > 0.)
    // Wall velocities count along the normal, inwards.
    box = {*size, -velocity("left") - velocity("right"), -velocity("bottom") - velocity("top"),
           -find_wall(snapshot.walls, "bottom")->slide_velocity -
               find_wall(snapshot.walls, "top")->slide_velocity};
}

double Assembly::rest_diameter(const unsigned int b) const
{
  return 2. * std::sqrt(snapshot.bodies[b].reference_area / M_PI);
}
} // namespace softgrain
