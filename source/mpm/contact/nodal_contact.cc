// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/nodal_contact.h>

#include <softgrain/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Point = dealii::Point<2>;
using Vector = dealii::Tensor<1, 2>;
using Row = ContactRow<2>;

/// A node of one body, by its number on the lattice.
struct Visit
{
  std::int64_t lattice;
  unsigned int body, node;

  bool operator<(const Visit &other) const
  {
    return lattice != other.lattice ? lattice < other.lattice : body < other.body;
  }
};

/// What one body shows at a node where it may touch something.
struct View
{
  double mass = 0.;                 ///< not moved to independent nodes [kg]
  Vector gradient;                  ///< of the mass (3.24); points out of the body [kg/m]
  std::vector<unsigned int> points; ///< that reach the node
};

/// Views of one body at the nodes asked for.
struct BodyViews
{
  std::vector<unsigned int> slot; ///< by local node, Row::none where nothing was asked
  std::vector<View> views;
  double uncut = 0.; ///< half the edge of a point's domain that no boundary has cut [m]

  void ask(const unsigned int node)
  {
    if (slot[node] == Row::none)
    {
      slot[node] = views.size();
      views.emplace_back();
    }
  }
  const View &operator()(const unsigned int node) const { return views[slot[node]]; }
};

void look(const Body<2> &body, BodyViews &at)
{
  const BodyField<2> &field = body.field;
  const unsigned int n = field.cells().nodes_per_cell();
  for (unsigned int p = 0; p < body.points.size(); ++p)
    at.uncut = std::max(at.uncut, body.points[p].half_extent());
  for (unsigned int c = 0; c < field.cells().n(); ++c)
  {
    const unsigned int *nodes = field.cells().nodes(c);
    for (unsigned int k = 0; k < n; ++k)
    {
      if (at.slot[nodes[k]] == Row::none)
        continue;
      View &view = at.views[at.slot[nodes[k]]];
      for (unsigned int p = field.cells().first_point(c); p < field.cells().first_point(c + 1); ++p)
        if (field.at_point(p).values[k] > 0.)
        {
          const double mass = body.points[p].mass();
          view.mass += mass * field.at_point(p).values[k];
          view.gradient += mass * field.at_point(p).slopes[k];
          view.points.push_back(p);
        }
    }
  }
}

/// Unit normal (3.24) out of the body, or zero when the body lies all around the node.
Vector outward(const View &view, const double cell_size)
{
  // A half space that ends at the node has a gradient of 2 m/h. What is left of it inside of a body is the
  // unevenness of its points, whose direction means nothing.
  constexpr double least = 0.2;
  const double size = view.gradient.norm();
  return size * cell_size > least * view.mass ? view.gradient / size : Vector();
}

/// Share of the mass at a node that changes over a cell: 2 for a half space that ends there.
double steepness(const View &view, const double cell_size)
{
  return view.gradient.norm() * cell_size / view.mass;
}

/// Vector from the body that shows @p other to the one that shows @p own, of length 0 to 2 (3.23).
Vector apart(const View &own, const View &other, const double cell_size)
{
  // A body that a blow has compressed is denser where the blow has come to, which is no surface. It is told
  // from one when it looks to where the other body ends, too, and is far less steep.
  constexpr double far_less = 0.25;
  const Vector outward_own = outward(own, cell_size), outward_other = outward(other, cell_size);
  if (outward_own * outward_other > 0.)
  {
    const double ratio = steepness(own, cell_size) / steepness(other, cell_size);
    if (ratio < far_less)
      return outward_other;
    if (ratio * far_less > 1.)
      return -outward_own;
  }
  return outward_other - outward_own;
}

/// How far the points that reach @p node stand out of the body along @p direction [m].
double extent(const Body<2> &body,
              const BodyViews &at,
              const unsigned int node,
              const Vector &direction,
              const double cell_size)
{
  // Points reach a node from two cells, over which a curved boundary rises or falls: those beside the node
  // count, and the others only where there are none.
  const Vector tangent({direction[1], -direction[0]});
  double beside = std::numeric_limits<double>::lowest(), anywhere = beside;
  for (const unsigned int p : at(node).points)
  {
    // Half the thickness along the normal of the ellipse that the circle in the domain of the point has
    // become. The boundary has cut the domains of its points to a thickness V / edge; half_extent is sqrt(V)
    // / 2.
    const auto point = body.points[p];
    const double cut = point.half_extent() / at.uncut;
    const double r = cut * point.half_extent() * (transpose(point.gradient()) * direction).norm();
    const double furthest = point.position() * direction + r;
    anywhere = std::max(anywhere, furthest);
    if (std::abs((point.position() - body.field.nodes().position(node)) * tangent) <= 0.5 * cell_size)
      beside = std::max(beside, furthest);
  }
  return beside > std::numeric_limits<double>::lowest() ? beside : anywhere;
}

std::uint64_t
row_key(const std::int64_t lattice, const unsigned int body, const unsigned int partner, const bool wall)
{
  // 27 bits for the node, 18 for each side: beyond that warm starts mix, results do not.
  return (static_cast<std::uint64_t>(lattice) << 37) | (static_cast<std::uint64_t>(wall) << 36) |
         (static_cast<std::uint64_t>(body & 0x3ffff) << 18) | (partner & 0x3ffff);
}

/// Fields of a row that do not depend on what is on the other side.
Row start_row(const Body<2> &body, const unsigned int node, const double cell_size)
{
  Row row;
  row.body = body.index;
  row.weights.body = body.field.extension().row(node).shared();
  row.place = body.field.nodes().position(node);
  row.length = cell_size;
  return row;
}

/// Runs of visits to the same node by two and more bodies.
template <typename F>
void for_shared_nodes(const std::vector<Visit> &visits, const F &f)
{
  for (std::size_t begin = 0; begin < visits.size();)
  {
    std::size_t end = begin + 1;
    while (end < visits.size() && visits[end].lattice == visits[begin].lattice)
      ++end;
    for (std::size_t a = begin; a < end; ++a)
      for (std::size_t b = a + 1; b < end; ++b)
        f(visits[a], visits[b]);
    begin = end;
  }
}

/// One search at the nodes of a scene.
class NodalSearch
{
public:
  /// @param reach of a shape function [m]
  NodalSearch(const ContactScene<2> &scene, double reach, bool with_gap);

  void add_rows_at_walls(std::vector<Row> &rows) const;
  void add_rows_of_bodies(std::vector<Row> &rows) const;

private:
  bool near_wall(const WallMotion<2> &wall, const Body<2> &body, const unsigned int node) const
  {
    return (body.field.nodes().position(node) - wall.point) * wall.normal < reach;
  }
  /// Asks for what nodes see that may touch a wall, or that two bodies share.
  void ask();
  void add_row_of_bodies(Visit first, Visit second, std::vector<Row> &rows) const;

  const ContactScene<2> &scene;
  const std::vector<Body<2>> &bodies;
  const double h, reach;
  const bool with_gap;
  /// Sorted by node: the cost is that of the nodes, however many bodies there are, and the order is always
  /// the same.
  std::vector<Visit> visits;
  std::vector<BodyViews> views;
};

NodalSearch::NodalSearch(const ContactScene<2> &scene, const double reach, const bool with_gap)
    : scene(scene)
    , bodies(scene.bodies)
    , h(scene.cell_size)
    , reach(reach)
    , with_gap(with_gap)
    , views(bodies.size())
{
  for (const Body<2> &body : bodies)
    for (unsigned int i = 0; i < body.field.nodes().n(); ++i)
      visits.push_back({body.field.nodes().lattice_number(i), body.index, i});
  std::sort(visits.begin(), visits.end());
  ask();
  parallel_for(bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (!views[b].views.empty())
                     look(bodies[b], views[b]);
               });
}

void NodalSearch::ask()
{
  for (const Body<2> &body : bodies)
    views[body.index].slot.assign(body.field.nodes().n(), Row::none);
  for (const Body<2> &body : bodies)
    if (!body.rigid.driven)
      for (const WallMotion<2> &wall : scene.walls)
        for (unsigned int i = 0; wall.plane && i < body.field.nodes().n(); ++i)
          if (near_wall(wall, body, i))
            views[body.index].ask(i);
  for_shared_nodes(visits,
                   [&](const Visit &a, const Visit &b)
                   {
                     if (bodies[a.body].rigid.driven && bodies[b.body].rigid.driven)
                       return;
                     views[a.body].ask(a.node);
                     views[b.body].ask(b.node);
                   });
}

void NodalSearch::add_rows_at_walls(std::vector<Row> &rows) const
{
  for (const Body<2> &body : bodies)
    if (!body.rigid.driven)
      for (unsigned int w = 0; w < scene.walls.size(); ++w)
        for (unsigned int i = 0; scene.walls[w].plane && i < body.field.nodes().n(); ++i)
        {
          const WallMotion<2> &wall = scene.walls[w];
          // Nodes that only boundary markers or empty corners of a stencil reach carry no mass: nothing is
          // there yet.
          if (!near_wall(wall, body, i) || views[body.index](i).points.empty())
            continue;
          Row row = start_row(body, i, h);
          row.wall = w;
          row.normal = wall.normal;
          row.gap =
              with_gap ? -extent(body, views[body.index], i, -wall.normal, h) - wall.point * wall.normal : 0.;
          take_pair(scene, row);
          row.key = row_key(body.field.nodes().lattice_number(i), body.index, w, true);
          rows.push_back(std::move(row));
        }
}

void NodalSearch::add_row_of_bodies(Visit first, Visit second, std::vector<Row> &rows) const
{
  if (bodies[first.body].rigid.driven)
    std::swap(first, second); // what is driven can only be the partner
  const Body<2> &body = bodies[first.body], &partner = bodies[second.body];
  if (body.rigid.driven)
    return;
  const View &own = views[first.body](first.node), &other = views[second.body](second.node);
  if (own.points.empty() || other.points.empty())
    return;
  const Vector normal = apart(own, other, h);
  // Both look the same way, or neither shows a surface here: the nodes around tell them apart.
  if (normal.norm() < 0.2)
    return;
  Row row = start_row(body, first.node, h);
  row.partner = partner.index;
  row.wall = partner.rigid.wall;
  row.weights.partner = partner.field.extension().row(second.node).shared();
  row.normal = normal / normal.norm();
  row.gap = with_gap ? -extent(body, views[body.index], first.node, -row.normal, h) -
                           extent(partner, views[partner.index], second.node, row.normal, h)
                     : 0.;
  take_pair(scene, row);
  row.key = row_key(first.lattice, body.index, partner.index, false);
  rows.push_back(std::move(row));
}

void NodalSearch::add_rows_of_bodies(std::vector<Row> &rows) const
{
  for_shared_nodes(visits, [&](const Visit &a, const Visit &b) { add_row_of_bodies(a, b, rows); });
}
} // namespace

NodalContact::NodalContact(const ShapeFunction &shape, const bool gap)
    // B-splines end one and a half cells from their node, hats one; GIMP adds the extent of a point, a
    // quarter of a cell.
    : reach(shape.degree() > 1    ? 1.5
            : shape.uses_extent() ? 1.25
                                  : 1.)
    , with_gap(gap)
{
}

void NodalContact::find(const ContactScene<2> &scene, std::vector<ContactRow<2>> &rows) const
{
  rows.clear();
  const NodalSearch search(scene, (reach - 1e-9) * scene.cell_size, with_gap);
  search.add_rows_at_walls(rows);
  search.add_rows_of_bodies(rows);
}
} // namespace softgrain::mpm
