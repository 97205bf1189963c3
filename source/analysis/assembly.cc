// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/assembly.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace softgrain
{
namespace
{
constexpr unsigned int none = ContactState<2>::not_a_body; // the same in space

/// The row seen from the body with the smaller index.
template <int dim>
ContactState<dim> ordered(ContactState<dim> row)
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

template <int dim>
BodyContactIn<dim> merged(const std::vector<ContactState<dim>> &rows)
{
  BodyContactIn<dim> contact;
  contact.body_a = rows[0].body_a;
  contact.body_b = rows[0].body_b;
  contact.wall = rows[0].wall;
  dealii::Tensor<1, dim> by_length, plain;
  for (const ContactState<dim> &row : rows)
  {
    contact.force += row.force;
    contact.length += row.length;
    by_length += row.length * row.normal;
    plain += row.normal;
  }
  // Normals of a rough contact may cancel; then the force is the best guess of where the partner is.
  const dealii::Tensor<1, dim> direction = by_length.norm() > 0. ? by_length
                                           : plain.norm() > 1e-9 ? plain
                                                                 : contact.force;
  contact.normal = direction.norm() > 0. ? direction / direction.norm() : rows[0].normal;
  contact.normal_force = contact.force * contact.normal;
  double weight = 0.;
  dealii::Tensor<1, dim> moment, mean;
  for (const ContactState<dim> &row : rows)
  {
    const double pressed = std::max(0., row.force * row.normal);
    weight += pressed;
    moment += pressed * (row.place - rows[0].place);
    mean += (row.place - rows[0].place) / static_cast<double>(rows.size());
  }
  contact.place = rows[0].place + (weight > 0. ? moment / weight : mean);
  // Disks that fit into each other's gaps touch twice on the way along a contact, and some models write a row
  // from either side: lengths then add up to more than there is room for.
  if constexpr (dim == 2)
  {
    const double room = extent(rows, contact.normal) + contact.length / rows.size();
    contact.length = contact.length > 0. ? std::min(contact.length, room) : room;
  }
  return contact;
}
} // namespace

template <int dim>
AssemblyIn<dim>::AssemblyIn(const Snapshot<dim> &snapshot, const MeasureContextIn<dim> &context)
    : snapshot(snapshot), context(context)
{
  // In a small cell that repeats a body may touch two images of another.
  std::map<std::tuple<unsigned int, unsigned int, unsigned int, std::array<double, dim>>,
           std::vector<ContactState<dim>>>
      groups;
  for (const ContactState<dim> &row : snapshot.contacts)
    if (row.wall != none)
    {
      groups[{row.body_a, none, row.wall, {}}].push_back(row);
      groups[{row.body_a, none, row.wall, {}}].back().body_b = none;
    }
    else if (row.body_a != row.body_b)
    {
      const ContactState<dim> seen = ordered(row);
      std::array<double, dim> image;
      for (unsigned int d = 0; d < dim; ++d)
        image[d] = seen.image[d];
      groups[{seen.body_a, seen.body_b, none, image}].push_back(seen);
    }
  for (const auto &group : groups)
    contacts.push_back(merged(group.second));

  const std::optional<Box<dim>> size = box_of(snapshot.walls);
  if (!size ||
      !std::all_of(size->edge.begin(), size->edge.end(), [](const double edge) { return edge > 0.; }))
    return;
  box.emplace();
  static_cast<Box<dim> &>(*box) = *size;
  for (unsigned int d = 0; d < dim; ++d) // wall velocities count along the normal, inwards
    box->rate[d] = -find_wall(snapshot.walls, Box<dim>::sides[2 * d])->velocity -
                   find_wall(snapshot.walls, Box<dim>::sides[2 * d + 1])->velocity;
  box->slide_rate =
      -find_wall(snapshot.walls, "bottom")->slide_velocity - find_wall(snapshot.walls, "top")->slide_velocity;
}

template <int dim>
double AssemblyIn<dim>::rest_diameter(const unsigned int b) const
{
  const double volume = snapshot.bodies[b].reference_area;
  return dim == 2 ? 2. * std::sqrt(volume / M_PI) : std::cbrt(6. * volume / M_PI);
}

template class AssemblyIn<2>;
template class AssemblyIn<3>;
} // namespace softgrain
