// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/contact_profile.h>
#include <softgrain/analysis/partner_numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace softgrain
{
namespace
{
using Contact = ContactState<2>;
using Vector = dealii::Tensor<1, 2>;

constexpr double narrow = 2.1;       ///< resolutions in a half width, up to which Hertz's law tells it better
constexpr std::size_t few = 4;       ///< places that bear a force, below which they tell no width
constexpr double terms_from = 5.;    ///< resolutions in a half width, from which on there are further terms
constexpr double corner = M_PI / 6.; ///< turn of an outline from one of its sides to the next
constexpr unsigned int n_places = 33; ///< along a smooth contact

/// One place of contact, seen by the first body.
struct Place
{
  double along = 0.; ///< from the line of the resultant [m]
  double pressed = 0., rubbed = 0., length = 0.;
  dealii::Point<2> point;
  Vector tangent;
};

/// With the body to the left its outward normal points to the right.
Place seen(const Contact &contact)
{
  Place place;
  place.point = contact.place;
  place.length = contact.length;
  place.tangent[0] = contact.normal[1];
  place.tangent[1] = -contact.normal[0];
  place.pressed = contact.force * contact.normal;
  place.rubbed = contact.force * place.tangent;
  return place;
}

template <typename Function>
double sum(const std::vector<Place> &places, const Function &value)
{
  return std::accumulate(places.begin(), places.end(), 0.,
                         [&](const double so_far, const Place &place) { return so_far + value(place); });
}

/// Sorts places along their contact. @return false where there is no way along: it goes all around
bool sort_along(std::vector<Place> &places)
{
  Vector mean;
  for (const Place &place : places)
    mean += place.length * place.tangent;
  if (mean.norm() < 0.5 * sum(places, [](const Place &p) { return p.length; }) || mean.norm() == 0.)
    return false;
  mean /= mean.norm();
  for (Place &place : places)
    place.along = place.point * mean;
  const double pressed = sum(places, [](const Place &p) { return std::max(p.pressed, 0.); });
  const double middle =
      pressed > 0. ? sum(places, [](const Place &p) { return std::max(p.pressed, 0.) * p.along; }) / pressed
                   : sum(places, [](const Place &p) { return p.along; }) / places.size();
  for (Place &place : places)
    place.along -= middle;
  std::stable_sort(places.begin(), places.end(),
                   [](const Place &p, const Place &q) { return p.along < q.along; });
  return true;
}

bool has_corners(const BodyState<2> &body)
{
  if (body.outline.empty())
    return false;
  std::vector<Vector> sides;
  const std::vector<dealii::Point<2>> &ring = body.outline[0];
  for (std::size_t v = 0; v < ring.size(); ++v)
    if (const Vector side = ring[(v + 1) % ring.size()] - ring[v]; side.norm() > 0.)
      sides.push_back(side);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const Vector &one = sides[s], &next = sides[(s + 1) % sides.size()];
    if (std::abs(std::atan2(one[0] * next[1] - one[1] * next[0], one * next)) > corner)
      return true;
  }
  return false;
}

/// Half the width on which both touch by Hertz's law, Johnson, Contact Mechanics (1985), section 4.2.
std::optional<double>
hertz_half_width(const Snapshot<2> &snapshot, const Contact &contact, const double force)
{
  double curvature = 0., compliance = 0.;
  const auto add = [&](const unsigned int b)
  {
    const BodyState<2> &body = snapshot.bodies[b];
    curvature += body.curvature;
    compliance += body.compliance;
    return body.curvature > 0.;
  };
  const bool at_wall = contact.wall != Contact::not_a_body;
  const bool may_be_bent = PartnerNumbers(snapshot.walls.size()).is_obstacle(contact.wall);
  if (may_be_bent || !add(contact.body_a) || (!at_wall && !add(contact.body_b)) || force <= 0. ||
      compliance <= 0.)
    return {};
  return std::sqrt(4. * force * compliance / (M_PI * curvature));
}

/// Sums c_n U_n(x) which, with 2/(π a) √(1-x²) before them, have the moments of forces at places, in half
/// widths a.
std::vector<double> series(const std::vector<Place> &places,
                           const double half,
                           double Place::*const force,
                           const unsigned int terms,
                           const std::vector<double> &x)
{
  std::vector<double> result;
  std::vector<double> weights;
  for (unsigned int n = 0; n <= terms; ++n)
    weights.push_back(0.);
  for (const Place &place : places)
  {
    const double at = std::clamp(place.along / half, -1., 1.);
    double now = 1., next = 2. * at;
    for (double &weight : weights)
    {
      weight += place.*force * now;
      const double after = 2. * at * next - now;
      now = next;
      next = after;
    }
  }
  for (const double at : x)
  {
    double now = 1., next = 2. * at, total = 0.;
    for (const double weight : weights)
    {
      total += weight * now;
      const double after = 2. * at * next - now;
      now = next;
      next = after;
    }
    result.push_back(total);
  }
  return result;
}

/// Where contact is at @p along, straight on beyond its ends.
dealii::Point<2> point_at(const std::vector<Place> &places, const double along)
{
  const Vector whole = places.back().point - places.front().point;
  const Vector way = whole.norm() > 0. ? whole / whole.norm() : places.front().tangent;
  if (along <= places.front().along || places.size() == 1)
    return places.front().point + (along - places.front().along) * way;
  if (along >= places.back().along)
    return places.back().point + (along - places.back().along) * way;
  const auto after =
      std::find_if(places.begin(), places.end(), [along](const Place &p) { return p.along > along; });
  const Place &before = *(after - 1);
  const double part = (along - before.along) / (after->along - before.along);
  return before.point + part * (after->point - before.point);
}

/// Pieces go on from each to the next.
void set_directions(std::vector<ContactPiece> &pieces, const Vector &of_one)
{
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const Vector way = pieces[std::min(i + 1, pieces.size() - 1)].place - pieces[i == 0 ? 0 : i - 1].place;
    pieces[i].direction = way.norm() > 0. ? way / way.norm() : of_one;
  }
}

/// Every place by itself.
std::vector<ContactPiece> single_places(const std::vector<Place> &places)
{
  std::vector<ContactPiece> pieces;
  for (const Place &place : places)
    if (place.length > 0.)
      pieces.push_back({place.point, place.tangent, place.length, place.pressed / place.length,
                        place.rubbed / place.length});
  return pieces;
}

/// One piece for each place, which hands a quarter of its force to the next on either side.
std::vector<ContactPiece> spread_places(std::vector<Place> places)
{
  const std::vector<Place> before = places;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (double Place::*const force : {&Place::pressed, &Place::rubbed})
    {
      const double moved = (before[i].*force - before[i + 1].*force) / 4.;
      places[i].*force -= moved;
      places[i + 1].*force += moved;
    }
  std::vector<ContactPiece> pieces = single_places(places);
  set_directions(pieces, places.front().tangent);
  return pieces;
}

/// The profile that has the moments of the forces at all places; none where they tell no width.
std::vector<ContactPiece> of_moments(const std::vector<Place> &places, const std::optional<double> &hertz)
{
  std::vector<double> lengths;
  for (const Place &place : places)
    lengths.push_back(place.length);
  std::sort(lengths.begin(), lengths.end());
  const double resolution = lengths[lengths.size() / 2] + lengths[(lengths.size() - 1) / 2];
  const double measured =
      2. * std::sqrt(sum(places, [](const Place &p) { return p.pressed * p.along * p.along; }) /
                     sum(places, [](const Place &p) { return p.pressed; }));
  const bool by_law = hertz && (*hertz < narrow * resolution || places.size() < few);
  if (!by_law && (places.size() < few || !(measured > 0.5 * resolution)))
    return {};
  const double half = by_law ? *hertz : measured;
  // In the middle of equal angles sums are integrals, exactly, and no place is an end of the contact.
  std::vector<double> x, root;
  for (unsigned int k = 1; k <= n_places; ++k)
  {
    const double angle = M_PI * k / (n_places + 1);
    x.push_back(-std::cos(angle));
    root.push_back(std::sin(angle));
  }
  const auto least = [](const std::vector<double> &values)
  { return *std::min_element(values.begin(), values.end()); };
  unsigned int terms = half < terms_from * resolution ? 1 : static_cast<unsigned int>(half / resolution) - 1;
  std::vector<double> pressed = series(places, half, &Place::pressed, terms, x);
  for (; terms > 1 && least(pressed) < 0.; pressed = series(places, half, &Place::pressed, terms, x))
    terms /= 2;
  if (least(pressed) < 0.)
    pressed = series(places, half, &Place::pressed, 0, x);
  const std::vector<double> rubbed =
      series(places, half, &Place::rubbed, std::min<std::size_t>(2, places.size() - 1), x);
  std::vector<ContactPiece> pieces;
  for (unsigned int k = 0; k < n_places; ++k)
  {
    const double density = 2. / (M_PI * half) * root[k];
    pieces.push_back({point_at(places, half * x[k]), Vector(), half * M_PI / (n_places + 1) * root[k],
                      density * pressed[k], density * rubbed[k]});
  }
  set_directions(pieces, places.front().tangent);
  return pieces;
}
} // namespace

std::vector<ContactPiece> contact_profile(const Snapshot<2> &snapshot, const std::vector<Contact> &contacts)
{
  std::vector<Place> places;
  for (const Contact &contact : contacts)
    places.push_back(seen(contact));
  if (places.empty() || !sort_along(places))
    return single_places(places);
  const Contact &first = contacts.front();
  const bool pulls =
      std::any_of(places.begin(), places.end(), [](const Place &place) { return place.pressed < 0.; });
  if (pulls || has_corners(snapshot.bodies[first.body_a]) ||
      (first.body_b != Contact::not_a_body && first.wall == Contact::not_a_body &&
       has_corners(snapshot.bodies[first.body_b])))
    return spread_places(places);
  const std::vector<ContactPiece> pieces = of_moments(
      places, hertz_half_width(snapshot, first, sum(places, [](const Place &p) { return p.pressed; })));
  return pieces.empty() ? single_places(places) : pieces;
}
} // namespace softgrain
