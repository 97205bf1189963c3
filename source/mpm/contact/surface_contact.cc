// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/contact_tasks.h>
#include <softgrain/mpm/contact/obstacle_contact.h>
#include <softgrain/mpm/contact/row_ends.h>
#include <softgrain/mpm/contact/seekers.h>
#include <softgrain/mpm/contact/share_outlines.h>
#include <softgrain/mpm/contact/sliding_places.h>
#include <softgrain/mpm/contact/surface_contact.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>

namespace softgrain::mpm
{
namespace
{
using Point = MovedBoundary::Point;
using Vector = MovedBoundary::Vector;
using Place = MovedBoundary::Place;
using Row = ContactRow<2>;

/// Key of an image of a partner: its low bits take the place of the high ones of the number of the partner.
unsigned int image_key(const Body<2> &partner, const PeriodicCell<2>::Image &image)
{
  return (partner.index & 0x7ffff) | ((image[0] & 3) << 21) | ((image[1] & 3) << 19);
}

/// See SubgridCompliance; of a place on an outline.
double log_full_width(const ContactScene<2> &scene,
                      const Body<2> &body,
                      const MovedBoundary &boundary,
                      const double parameter)
{
  if (!scene.subgrid.on || !SubgridCompliance::is_round(body))
    return 0.;
  const auto [place, normal] = boundary.on_grid(parameter);
  return scene.subgrid.log_full_width(body.law->poisson_ratio(), place, normal);
}

void find_wall_rows(const ContactScene<2> &scene,
                    const ContactReach &reach,
                    const Body<2> &body,
                    const MovedBoundary &own,
                    std::vector<Row> &rows)
{
  for (unsigned int w = 0; w < scene.walls.size(); ++w)
  {
    const WallMotion<2> &wall = scene.walls[w];
    if (!wall.plane)
      continue;
    const double way = scene.dt * wall.velocity;
    const double margin = reach(std::abs(own.travel * wall.normal - way) + own.spread);
    if (own.distance_from(wall.point, wall.normal) - scene.share * way > margin)
      continue;
    std::shared_ptr<const PlaceSlide<2>> slide;
    if (own.is_free && scene.places_slide && !scene.gaps_only)
      slide = slide_of_places(own, -wall.normal, nullptr);
    for_places(own, -wall.normal,
               [&](const Seeker &seeker)
               {
                 const Place &at = seeker.at;
                 const auto gap_at = [&](const Place &place)
                 { return (place.position - wall.point) * wall.normal - scene.share * way; };
                 const double gap = gap_at(at);
                 const double start = gap - scene.share * (at.displacement * wall.normal - way);
                 if (std::min(gap, start) > margin)
                   return gap < margin + scene.cell_size;
                 Row row;
                 row.body = body.index;
                 row.wall = w;
                 row.gap_where_found = gap;
                 row.key = row_key(body.index, seeker.number, w, true);
                 if (scene.gaps_only)
                 {
                   rows.push_back(std::move(row));
                   return true;
                 }
                 row.body_weights = own.weights(seeker.parameter).shared();
                 row.place = at.position;
                 row.normal = wall.normal;
                 row.log_full_width[0] = log_full_width(scene, body, own, seeker.parameter);
                 row.gap = start;
                 row.length = tributary_length(own, seeker);
                 take_pair(scene, row);
                 if (row.adhesion > 0.)
                 {
                   row.adhesion *= facing_share(own, seeker, row.normal);
                   add_lift(own, seeker, gap_at, row);
                 }
                 if (scene.cell != nullptr)
                   row.branch = own.start - (at.position - scene.share * at.displacement);
                 add_slope(scene, at, slide, row);
                 rows.push_back(std::move(row));
                 return true;
               });
  }
}

/// Place on a boundary nearest to a point.
struct Projection
{
  double distance = std::numeric_limits<double>::max();
  unsigned int first = 0; ///< marker at the start of the segment
  double share = 0;       ///< of the way to the next one
};

/// Takes segment @p s for @p best when it is nearer to @p x; @return its distance.
double look_at_segment(const Point &x,
                       const Vector &own_normal,
                       const MovedBoundary &other,
                       const unsigned int s,
                       Projection &best)
{
  const Point &a = other.marker(s), &b = other.marker(other.boundary().next(s));
  const Vector edge = b - a;
  const double square = edge.norm_square();
  if (square == 0.)
    return best.distance;
  const double share = std::clamp((x - a) * edge / square, 0., 1.);
  const double distance = x.distance(a + share * edge);
  if (distance < best.distance &&
      edge[1] * own_normal[0] - edge[0] * own_normal[1] <= 0.2 * std::sqrt(square))
    best = {distance, s, share};
  return distance;
}

/// Rows of one pair of bodies.
class PairSearch
{
public:
  PairSearch(const ContactScene<2> &scene,
             const double margin,
             const Body<2> &body,
             const MovedBoundary &own,
             const Body<2> &partner,
             const MovedBoundary &other,
             const PeriodicCell<2>::Image &image)
      : scene(scene), margin(margin), body(body), own(own), partner(partner), other(other), image(image)
  {
    // Segments one cell further than the margin: the nearest point of a place within it lies on one of them.
    const double wide = margin + scene.cell_size;
    for (unsigned int s = 0; s < other.n_markers(); ++s)
      if (own.near(other.marker(s), wide) || own.near(other.marker(other.boundary().next(s)), wide) ||
          partner.driven)
        segments.push_back(s);
  }

  /// All places of the body that look for contact.
  void look_everywhere(std::vector<Row> &rows) const
  {
    if (!segments.empty())
      for_places(own, direction(), [&](const Seeker &seeker) { return look(seeker, rows); });
  }

  /// Corners alone: what lies between them is looked for by the partner.
  void look_with_corners(std::vector<Row> &rows) const
  {
    if (!segments.empty())
      for (unsigned int m = 0; m < own.n_markers(); ++m)
        if (own.boundary().corner[m])
          look({own.place(m, 0.), static_cast<double>(m), m}, rows, true);
  }

private:
  /// Direction from the centre of a round body towards its partner.
  Vector direction() const
  {
    if (other.boundary().circular)
      return other.center - own.center;
    double nearest = std::numeric_limits<double>::max();
    Vector to;
    for (const unsigned int s : segments)
    {
      const Point &a = other.marker(s), &b = other.marker(other.boundary().next(s));
      const Vector edge = b - a;
      const double share =
          edge.norm_square() > 0. ? std::clamp((own.center - a) * edge / edge.norm_square(), 0., 1.) : 0.;
      const Vector way = a + share * edge - own.center;
      if (way.norm() < nearest)
      {
        nearest = way.norm();
        to = way;
      }
    }
    return to;
  }

  /// The segment that is nearest to a place, among those that look at it.
  Projection project(const Place &at) const
  {
    Projection best;
    for (const unsigned int s : segments)
      look_at_segment(at.position, at.normal, other, s, best);
    return best;
  }

  /// Gap from a place to the partner across; none when the partner is not there [m].
  double gap_beside(const Place &at) const
  {
    const Projection found = project(at);
    const double none = std::numeric_limits<double>::infinity();
    if (found.distance == std::numeric_limits<double>::max())
      return none;
    const Place opposite = other.place(found.first, found.share);
    const double gap = (at.position - opposite.position) * opposite.normal;
    return is_far_aside(gap, found.distance) ? none : gap;
  }

  /// Whether a place lies aside: the true nearest place looks the other way, and there is no contact.
  bool is_far_aside(const double gap, const double distance) const
  {
    return std::abs(gap) < 0.7 * distance && distance > 0.1 * scene.cell_size;
  }

  /// Behind the far side of a partner that it is not inside of: a place beside a thin one, whose near side
  /// looks the other way.
  bool is_far_side(const Place &at, const double gap) const
  {
    return gap < -0.5 * scene.cell_size && !other.encloses(at.position);
  }

  /// @return whether the partner is near
  bool look(const Seeker &seeker, std::vector<Row> &rows, const bool corners_only = false) const
  {
    const Place &at = seeker.at;
    const double far = margin + 2. * scene.cell_size;
    // Deformed bodies may touch beside the line of their centres alone: the search goes on from a place that
    // is beyond the margin there.
    if (!other.near(at.position, margin))
      return other.near(at.position, far);
    const Projection found = project(at);
    // Deeper than two cells is the far side of a thin partner, not a contact.
    if (found.distance > far)
      return false;
    const Place opposite = other.place(found.first, found.share);
    const double gap = (at.position - opposite.position) * opposite.normal;
    const double start = gap - scene.share * ((at.displacement - opposite.displacement) * opposite.normal);
    if (std::min(gap, start) > margin)
      return true;
    if (is_far_aside(gap, found.distance) || is_far_side(at, gap))
      return true;
    Row row;
    row.body = body.index;
    row.partner = partner.index;
    row.wall = partner.wall;
    row.gap_where_found = gap;
    row.key = scene.cell != nullptr ? row_key(body.index, seeker.number, image_key(partner, image), false)
                                    : row_key(body.index, seeker.number, partner.index, false);
    if (scene.gaps_only)
    {
      rows.push_back(std::move(row));
      return true;
    }
    take_pair(scene, row);
    if (row.adhesion == 0. && gap >= 0. && is_held_by_a_corner(found, seeker, corners_only))
      return true;
    row.body_weights = own.weights(seeker.parameter).shared();
    row.partner_marker = found.first;
    row.partner_share = found.share;
    if (partner.driven || partner.field.knows_markers())
      row.partner_weights = other.weights(found.first, found.share).shared();
    row.place = at.position;
    row.normal = opposite.normal;
    row.log_full_width = {{log_full_width(scene, body, own, seeker.parameter),
                           log_full_width(scene, partner, other, found.first + found.share)}};
    row.gap = start;
    row.length = tributary_length(own, seeker);
    // What lies around the corners of a partner is held by the rows of the one that looks everywhere.
    if (row.adhesion > 0.)
      row.adhesion *= corners_only ? 0. : facing_share(own, seeker, row.normal);
    if (row.adhesion > 0.)
      add_lift(
          own, seeker, [this](const Place &place) { return gap_beside(place); }, row);
    if (scene.cell != nullptr)
    {
      row.branch = own.start - other.start;
      row.image = image;
    }
    if (scene.places_slide && own.is_free && other.boundary().circular && !partner.driven)
    {
      if (!slide)
        slide = slide_of_places(own, direction(), &other);
      add_slope(scene, at, *slide, row);
    }
    rows.push_back(std::move(row));
    return true;
  }

  /// Whether what is nearest to a place is a corner of the partner, which looks back: its row has the normal
  /// of the side that it touches. Where two corners meet the row is of the one that looks everywhere.
  bool is_held_by_a_corner(const Projection &found, const Seeker &seeker, const bool corners_only) const
  {
    if (partner.driven || !other.at_corner(found.first, found.share))
      return false;
    return corners_only || own.is_free || !own.boundary().corner[seeker.number];
  }

  const ContactScene<2> &scene;
  const double margin;
  const Body<2> &body;
  const MovedBoundary &own;
  const Body<2> &partner;
  const MovedBoundary &other;
  const PeriodicCell<2>::Image image; ///< of the partner, as ContactRow::image
  std::vector<unsigned int> segments;
  mutable std::optional<std::shared_ptr<const PlaceSlide<2>>> slide; ///< made when there is a row
};
} // namespace

void SurfaceContact::find(const ContactScene<2> &scene, std::vector<ContactRow<2>> &rows) const
{
  const std::size_t n = scene.bodies.size();
  const ObstacleContact obstacles(scene);
  const ContactReach reach(scene, obstacles.largest_way());
  const MovedOutlines moved = scene.moved != nullptr ? std::move(*scene.moved) : move_outlines(scene);
  const std::vector<MovedBoundary> &boundaries = moved.boundaries;
  const std::vector<PeriodicCell<2>::Image> &folds = moved.folds;
  const std::vector<std::vector<ContactTask>> &tasks = moved.tasks;
  std::vector<std::vector<Row>> of_body(n);
  parallel_for(
      n, 4,
      [&](const std::size_t begin, const std::size_t end)
      {
        for (std::size_t b = begin; b < end; ++b)
        {
          if (scene.looking != nullptr && !scene.looking->mine(b))
            continue;
          const Body<2> &body = scene.bodies[b];
          const MovedBoundary &own = boundaries[b];
          if (!body.driven)
          {
            find_wall_rows(scene, reach, body, own, of_body[b]);
            obstacles.find(body, own, reach(0.), of_body[b]);
          }
          for (const ContactTask &task : tasks[b])
          {
            MovedBoundary away;
            if (task.image != PeriodicCell<2>::Image())
              away = image_of(boundaries[task.partner], task.image, scene);
            const MovedBoundary &other =
                task.image != PeriodicCell<2>::Image() ? away : boundaries[task.partner];
            const double margin = reach((own.travel - other.travel).norm() + own.spread + other.spread);
            if (!own.near(other, margin))
              continue;
            PeriodicCell<2>::Image image{};
            for (unsigned int d = 0; d < 2 && !folds.empty(); ++d)
              image[d] = task.image[d] - folds[task.partner][d] + folds[b][d] + body.home[d] -
                         scene.bodies[task.partner].home[d];
            const PairSearch search(scene, margin, body, own, scene.bodies[task.partner], other, image);
            if (task.corners_only)
              search.look_with_corners(of_body[b]);
            else
              search.look_everywhere(of_body[b]);
          }
        }
      });
  for (unsigned int b = 0; b < folds.size(); ++b)
    for (Row &row : of_body[b])
      for (unsigned int d = 0; d < 2; ++d)
        row.fold[d] = folds[b][d] + scene.bodies[b].home[d];
  std::size_t n_rows = 0;
  for (const std::vector<Row> &found : of_body)
    n_rows += found.size();
  rows.clear();
  rows.reserve(n_rows);
  for (std::vector<Row> &found : of_body)
    rows.insert(rows.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
}
} // namespace softgrain::mpm
