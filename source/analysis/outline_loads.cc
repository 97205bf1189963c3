// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/contact_profile.h>
#include <softgrain/analysis/outline_loads.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace softgrain
{
namespace
{
using Ring = std::vector<dealii::Point<2>>;
using Contact = ContactState<2>;
using Vector = dealii::Tensor<1, 2>;

/// Into which a piece of contact is cut: more would not change what a picture shows.
constexpr unsigned int n_parts = 8;

/// Vertices of a ring, of which the last one may be the first one again.
unsigned int n_vertices(const Ring &ring)
{
  return ring.size() - (ring.size() > 1 && ring.front() == ring.back() ? 1 : 0);
}

struct Side
{
  std::size_t ring = 0;
  unsigned int vertex = 0, next = 0; ///< at its ends
};

std::vector<Side> all_sides(const std::vector<Ring> &outline)
{
  std::vector<Side> sides;
  for (std::size_t r = 0; r < outline.size(); ++r)
    for (unsigned int v = 0, n = n_vertices(outline[r]); v < n; ++v)
      sides.push_back({r, v, (v + 1) % n});
  return sides;
}

struct PlaceOnOutline
{
  Side side;
  double along = 0.;                                         ///< of the side, in [0, 1]
  double distance = std::numeric_limits<double>::infinity(); ///< [m]
};

/// The place of a side that is nearest to @p place.
PlaceOnOutline place_on(const std::vector<Ring> &outline, const Side &side, const dealii::Point<2> &place)
{
  const dealii::Point<2> &start = outline[side.ring][side.vertex];
  const Vector way = outline[side.ring][side.next] - start;
  const double length = way.norm_square();
  const double along = length > 0. ? std::clamp((place - start) * way / length, 0., 1.) : 0.;
  return {side, along, (start + along * way - place).norm()};
}

PlaceOnOutline
nearest_on(const std::vector<Ring> &outline, const std::vector<Side> &sides, const dealii::Point<2> &place)
{
  PlaceOnOutline best;
  for (const Side &side : sides)
    if (const PlaceOnOutline at = place_on(outline, side, place); at.distance < best.distance)
      best = at;
  return best;
}

/// Loads are forces until the end, when they are divided by lengths.
using Loads = std::vector<std::vector<OutlineLoad>>;

Loads unloaded(const std::vector<Ring> &outline)
{
  Loads loads(outline.size());
  for (std::size_t r = 0; r < outline.size(); ++r)
  {
    const unsigned int n = n_vertices(outline[r]);
    loads[r].resize(n);
    for (unsigned int v = 0; v < n; ++v)
    {
      const double half = 0.5 * outline[r][v].distance(outline[r][(v + 1) % n]);
      loads[r][v].length += half;
      loads[r][(v + 1) % n].length += half;
    }
  }
  return loads;
}

/// The sides of an outline that may be the nearest to one of the pieces of a contact.
std::vector<Side>
sides_near(const std::vector<Ring> &outline, const std::vector<ContactPiece> &pieces, const Vector &shift)
{
  std::vector<Side> sides = all_sides(outline);
  const dealii::Point<2> first = pieces.front().place - shift;
  double reach = 0.;
  for (const ContactPiece &piece : pieces)
    reach = std::max(reach, (piece.place - shift - first).norm() + 0.5 * piece.length);
  // A place is as far from its nearest side as the first one is from its own and from the place, at most.
  const PlaceOnOutline nearest = nearest_on(outline, sides, first);
  const double limit = nearest.distance + 2. * reach;
  sides.erase(std::remove_if(sides.begin(), sides.end(),
                             [&](const Side &side)
                             { return place_on(outline, side, first).distance > limit; }),
              sides.end());
  return sides;
}

/// Hands the forces of the pieces of a contact to the vertices of an outline.
void press(Loads &loads,
           const std::vector<Ring> &outline,
           const std::vector<ContactPiece> &pieces,
           const Vector &shift)
{
  const std::vector<Side> sides = sides_near(outline, pieces, shift);
  for (const ContactPiece &piece : pieces)
    for (unsigned int part = 0; part < n_parts; ++part)
    {
      const double along = ((part + 0.5) / n_parts - 0.5) * piece.length;
      const PlaceOnOutline at = nearest_on(outline, sides, piece.place - shift + along * piece.direction);
      const auto add = [&](const unsigned int vertex, const double share)
      {
        OutlineLoad &load = loads[at.side.ring][vertex];
        load.pressure += share * piece.pressure * piece.length / n_parts;
        load.traction += share * piece.traction * piece.length / n_parts;
      };
      add(at.side.vertex, 1. - at.along);
      add(at.side.next, at.along);
    }
}

/// Places of contact of a body with one partner, or one image of it.
std::vector<std::vector<Contact>> by_pairs(const std::vector<Contact> &contacts)
{
  std::map<std::array<double, 5>, std::vector<Contact>> pairs;
  for (const Contact &contact : contacts)
    pairs[{double(contact.body_a), double(contact.body_b), double(contact.wall), contact.image[0],
           contact.image[1]}]
        .push_back(contact);
  std::vector<std::vector<Contact>> result;
  for (auto &[pair, places] : pairs)
    result.push_back(std::move(places));
  return result;
}
} // namespace

std::vector<std::vector<std::vector<OutlineLoad>>> loads_on_outlines(const Snapshot<2> &snapshot)
{
  std::vector<Loads> loads;
  for (const BodyState<2> &body : snapshot.bodies)
    loads.push_back(unloaded(body.outline));
  for (const std::vector<Contact> &places : by_pairs(snapshot.contacts))
  {
    const Contact &pair = places.front();
    const std::vector<ContactPiece> pieces = contact_profile(snapshot, places);
    // On its partner the force is the opposite one and so is the normal: pressure and traction are the same.
    const auto press_body = [&](const unsigned int body, const Vector &shift)
    {
      if (body != Contact::not_a_body && !pieces.empty() && !loads[body].empty())
        press(loads[body], snapshot.bodies[body].outline, pieces, shift);
    };
    press_body(pair.body_a, Vector());
    if (pair.wall == Contact::not_a_body)
      press_body(pair.body_b, pair.image);
  }
  for (Loads &of_body : loads)
    for (std::vector<OutlineLoad> &ring : of_body)
      for (OutlineLoad &load : ring)
        if (load.length > 0.)
        {
          load.pressure /= load.length;
          load.traction /= load.length;
        }
  return loads;
}
} // namespace softgrain
