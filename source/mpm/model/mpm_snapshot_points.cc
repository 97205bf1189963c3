// SPDX-License-Identifier: LGPL-2.1-or-later
// The points in a snapshot of MpmModel: every owner tells of its own, the first one gets all.
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/model/point_history.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int not_a_wall = static_cast<unsigned int>(-1);

/// Value of a nodal vector at one point.
dealii::Tensor<1, 2> field_at(const BodyField<2> &field, const unsigned int p, const Eigen::VectorXd &nodal)
{
  dealii::Tensor<1, 2> value;
  for (unsigned int k = 0; k < field.cells().nodes_per_cell(); ++k)
  {
    const unsigned int i = field.at_point(p).nodes[k];
    value += field.at_point(p).values[k] * dealii::Tensor<1, 2>({nodal[2 * i], nodal[2 * i + 1]});
  }
  return value;
}

/// Where the points of a body stand in the lists of an owner.
struct Section
{
  const Body<2> *body;
  unsigned int owner;
  std::size_t begin;
};

/// Those of all bodies that are shown, in their order. @param room for owned ones, on the first for
/// those of all
std::vector<Section> sections_of(const State &state, const BodyShare &share, std::size_t &room)
{
  std::vector<Section> sections;
  room = 0;
  for (const Body<2> &body : state.bodies)
    if (body.rigid.wall == not_a_wall)
    {
      sections.push_back({&body, share.owner(body.index), room});
      if (share.exchange.first() || share.mine(body.index))
        room += body.n_points;
    }
  return sections;
}

void resize(PointStates<2> &points, const std::size_t n)
{
  points.position.resize(n);
  points.body.resize(n);
  points.size.resize(n);
  points.velocity.resize(n);
  points.stress.resize(n);
  points.out_of_plane_stress.resize(n);
  points.deformation_gradient.resize(n);
}

/// The points of a body in the order of their ids, which does not change when they are sorted by cell. Size,
/// stress and F belong together: all three are those of the volume that the law sees, so with F-bar that of
/// the cell for the most part, and size times stress is what the point adds to the forces.
void put_points(const Body<2> &body, const std::size_t begin, PointStates<2> &points)
{
  Eigen::VectorXd u, v;
  body.field.extension().prolongate(body.nodes.displacement, u);
  if (body.nodes.velocity.size() > 0)
    body.field.extension().prolongate(body.nodes.velocity, v);
  const PointMeasures<2> seen =
      measure_points(body, body.nodes.displacement, Eigen::VectorXd::Zero(body.field.n_dofs()));
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const auto point = body.points[p];
    const std::size_t at = begin + body.points.number(p);
    const dealii::Tensor<2, 2> &F = seen.gradient[p];
    const double volume = determinant(F), J = body.material.small_strain() ? 1. : volume;
    points.position[at] = point.position() + field_at(body.field, p, u);
    points.velocity[at] = body.nodes.velocity.size() > 0 ? field_at(body.field, p, v) : body.rigid.drive;
    points.size[at] = point.rest_volume() * volume;
    points.stress[at] = point.stress() / J;
    points.out_of_plane_stress[at] = seen.out_of_plane_stress[p] / J;
    points.deformation_gradient[at] = F;
  }
}

/// All numbers of the points as pieces of their owners, for Exchange::bring().
std::vector<Exchange::Piece>
pieces_of(const std::vector<Section> &sections, const Exchange &exchange, PointStates<2> &points)
{
  std::vector<Exchange::Piece> pieces;
  for (const Section &section : sections)
  {
    if (!exchange.first() && section.owner != exchange.here())
      continue; // what it names would be no place here
    const std::size_t begin = section.begin, n = section.body->n_points;
    if (n == 0)
      continue;
    const auto add = [&](auto &list)
    {
      double *const first = reinterpret_cast<double *>(&list[begin]);
      pieces.push_back({section.owner, first, n * sizeof(list[begin]) / sizeof(double)});
    };
    add(points.position);
    add(points.size);
    add(points.velocity);
    add(points.stress);
    add(points.out_of_plane_stress);
    add(points.deformation_gradient);
    for (NamedField &field : points.extra)
      add(field.values);
  }
  return pieces;
}
} // namespace

PointStates<2> MpmModel::point_states() const
{
  const BodyShare &share = work.share;
  PointStates<2> points;
  std::vector<Section> sections;
  share.exchange.together(
      [&]()
      {
        std::size_t room = 0;
        sections = sections_of(state, share, room);
        resize(points, room);
        for (const Section &section : sections)
          add_history_fields(*section.body->material.law, points);
        for (const Section &section : sections)
          if (share.mine(section.body->index))
          {
            put_points(*section.body, section.begin, points);
            const Body<2> &body = *section.body;
            put_history(
                body, [&](const unsigned int p) { return section.begin + body.points.number(p); }, points);
          }
      });
  share.exchange.bring(pieces_of(sections, share.exchange, points));
  if (!share.exchange.first())
    return {};
  for (const Section &section : sections)
    std::fill_n(points.body.begin() + section.begin, section.body->n_points, section.body->index);
  return points;
}
} // namespace softgrain::mpm
