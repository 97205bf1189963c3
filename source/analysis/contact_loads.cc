// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/contact_loads.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/nearest_name.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>

namespace softgrain
{
namespace
{
const std::string parameter = "'Output/Forces on'";

using Row = std::vector<std::pair<std::string, double>>;

void add(const std::string &name, const dealii::Tensor<1, 2> &force, const double torque, Row &row)
{
  row.emplace_back(name + "_force_x_N_per_m", force[0]);
  row.emplace_back(name + "_force_y_N_per_m", force[1]);
  row.emplace_back(name + "_torque_N", torque);
}

double turning(const dealii::Tensor<1, 2> &arm, const dealii::Tensor<1, 2> &force)
{
  return arm[0] * force[1] - arm[1] * force[0];
}
} // namespace

std::vector<LoadWish> parse_load_wishes(const std::string &text)
{
  std::vector<LoadWish> wishes;
  for (const std::string &entry : dealii::Utilities::split_string_list(text, ','))
  {
    const std::vector<std::string> parts = dealii::Utilities::split_string_list(entry, '/');
    const bool good =
        (parts.size() == 1 || parts.size() == 2) &&
        std::none_of(parts.begin(), parts.end(), [](const std::string &p) { return p.empty(); });
    if (!good)
      throw InputError(parameter + " = '" + text + "' is not allowed: '" + entry +
                       "' must be 'NAME' or 'NAME / PARTNER'");
    wishes.push_back({parts[0], parts.size() == 2 ? parts[1] : ""});
  }
  return wishes;
}

ContactLoads::ContactLoads(const std::vector<LoadWish> &wishes,
                           const std::vector<std::string> &bodies,
                           const std::vector<std::string> &walls,
                           const std::vector<std::string> &obstacles,
                           const std::vector<char> &repeats)
{
  std::vector<std::string> fixed = walls;
  fixed.insert(fixed.end(), obstacles.begin(), obstacles.end());
  const auto find = [&](const std::string &name)
  {
    const auto count = [&name](const auto &names) { return std::count(names.begin(), names.end(), name); };
    const auto index = [&name](const auto &names)
    { return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()); };
    const auto of_bodies = count(bodies), of_fixed = count(fixed);
    if (of_bodies + of_fixed > 1)
      throw InputError(parameter + ": more than one body, wall or obstacle is named '" + name +
                       "': give them names of their own");
    if (of_bodies + of_fixed == 0)
    {
      std::vector<std::string> known = bodies;
      known.insert(known.end(), fixed.begin(), fixed.end());
      const std::string near = nearest_name(name, known);
      known.resize(std::min<std::size_t>(known.size(), 12));
      throw InputError(parameter + ": no body, wall or obstacle is named '" + name + "'; there are: " +
                       join(known) + (bodies.size() + fixed.size() > known.size() ? ", ..." : "") +
                       (near.empty() ? "" : " (did you mean '" + near + "'?)"));
    }
    const Place place{of_bodies == 1, index(of_bodies == 1 ? bodies : fixed)};
    if (!place.is_body && place.index < repeats.size() && repeats[place.index])
      throw InputError(parameter + ": '" + name +
                       "' is a side of a cell that repeats: bodies go through it, and nothing touches it");
    return place;
  };
  Mistakes mistakes;
  for (const LoadWish &wish : wishes)
    mistakes.attempt(
        [&]()
        {
          Wanted next{
              wish.on + (wish.from.empty() ? "_contact" : "_from_" + wish.from), find(wish.on), {}, true};
          if (!wish.from.empty())
          {
            next.from = find(wish.from);
            next.of_all = false;
            if (next.on == next.from)
              throw InputError(parameter + ": '" + wish.on + "' is no partner of itself");
            if (!next.on.is_body && !next.from.is_body)
              throw InputError(parameter + ": '" + wish.on + "' and '" + wish.from +
                               "' are no bodies, and never touch");
          }
          for (const Wanted &other : wanted)
            if (other.name == next.name)
              throw InputError(parameter + ": two entries have columns of the name '" + next.name + "'");
          wanted.push_back(next);
        });
  mistakes.end();
}

dealii::Point<2> ContactLoads::reference_of(const Place &place, const Snapshot<2> &touching)
{
  if (place.is_body)
    return touching.bodies.at(place.index).center;
  return place.index < touching.walls.size()
             ? touching.walls[place.index].point
             : touching.obstacles.at(place.index - touching.walls.size()).pivot;
}

Row ContactLoads::evaluate(const Snapshot<2> &touching) const
{
  Row row;
  for (const Wanted &load : wanted)
  {
    dealii::Tensor<1, 2> total;
    double torque = 0.;
    const dealii::Point<2> reference = reference_of(load.on, touching);
    for (const ContactState<2> &contact : touching.contacts)
    {
      const bool with_wall = contact.wall != ContactState<2>::not_a_body;
      const Place a{true, contact.body_a};
      const Place b{!with_wall, with_wall ? contact.wall : contact.body_b};
      if (a == b)
        continue; // within an aggregate
      const auto feels = [&](const Place &self, const Place &other)
      { return self == load.on && (load.of_all || other == load.from); };
      // The partner feels the opposite, of a cell that repeats in the place of its own image.
      if (feels(a, b))
      {
        total += contact.force;
        torque += turning(contact.place - reference, contact.force);
      }
      if (feels(b, a))
      {
        total -= contact.force;
        torque -= turning(contact.place - contact.image - reference, contact.force);
      }
    }
    add(load.name, total, torque, row);
  }
  return row;
}

Row ContactLoads::unknown() const
{
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  Row row;
  for (const Wanted &load : wanted)
    add(load.name, dealii::Tensor<1, 2>({nothing, nothing}), nothing, row);
  return row;
}
} // namespace softgrain
