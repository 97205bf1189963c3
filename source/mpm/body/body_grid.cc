// SPDX-License-Identifier: LGPL-2.1-or-later
// How a body gets its grid and leaves it.
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/body/at_marker.h>
#include <softgrain/mpm/body/body_builder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace softgrain::mpm
{
namespace
{
dealii::Tensor<2, 2> unit()
{
  dealii::Tensor<2, 2> one;
  one[0][0] = one[1][1] = 1.;
  return one;
}

/// The momentum of the matrices B that points have with APIC. An independent node at x_i gets the sum of
/// m N B (x_i - x_p) over the points. N includes what the nodes that follow this one pass on to it. Their own
/// places must not stand for x_i: a linear field of velocities would change with every transfer, and grow.
class AffineMomentum
{
public:
  explicit AffineMomentum(const BodyField<2> &field)
      : field(field), origin(field.nodes().position(0)), sum{{zero(field), zero(field)}}
  {
  }

  /// Adds m N of a point to a node. @return the velocity that is to be added to that of the point
  dealii::Tensor<1, 2> add(const dealii::Tensor<2, 2> &affine,
                           const dealii::Point<2> &place,
                           const unsigned int node,
                           const double mass)
  {
    for (unsigned int e = 0; e < 2; ++e)
      for (unsigned int d = 0; d < 2; ++d)
        sum[e][2 * node + d] += mass * affine[d][e];
    return affine * (origin - place);
  }
  /// Adds it to the momentum of independent nodes.
  void add_to(Eigen::VectorXd &momentum) const
  {
    Eigen::VectorXd restricted;
    for (unsigned int e = 0; e < 2; ++e)
    {
      field.extension().restrict(sum[e], restricted);
      for (unsigned int i = 0; i < field.n_independent(); ++i)
        momentum.segment<2>(2 * i) += (field.place(i) - origin)[e] * restricted.segment<2>(2 * i);
    }
  }

private:
  static Eigen::VectorXd zero(const BodyField<2> &field)
  {
    return Eigen::VectorXd::Zero(2 * field.nodes().n());
  }

  const BodyField<2> &field;
  const dealii::Point<2> origin; ///< from which places are measured
  std::array<Eigen::VectorXd, 2> sum;
};

/// Mass and velocity of the nodes; false when an independent node is left without mass, or
/// without positive mass where @p positive ones are asked for.
bool points_to_nodes(Body<2> &body, const bool positive)
{
  const BodyField<2> &field = body.field;
  const bool moving = body.points.layout().has(PointSlot::velocity),
             affine = moving && body.points.layout().has(PointSlot::affine);
  const unsigned int n = field.cells().nodes_per_cell();
  std::vector<double> mass(field.nodes().n(), 0.);
  Eigen::VectorXd momentum = Eigen::VectorXd::Zero(2 * field.nodes().n());
  std::optional<AffineMomentum> of_matrices;
  if (affine)
    of_matrices.emplace(field);
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const auto point = body.points[p];
    for (unsigned int k = 0; k < n; ++k)
    {
      const unsigned int i = field.at_point(p).nodes[k];
      const double m = point.mass() * field.at_point(p).values[k];
      mass[i] += m;
      dealii::Tensor<1, 2> v;
      if (moving)
        v = point.velocity();
      if (affine)
        v += of_matrices->add(point.affine(), point.position(), i, m);
      for (unsigned int d = 0; d < 2; ++d)
        momentum[2 * i + d] += m * v[d];
    }
  }
  body.nodes.mass = field.extension().restrict_scalar(mass);
  if (body.nodes.mass.size() == 0 ||
      !((positive ? body.nodes.mass.minCoeff() : body.nodes.mass.cwiseAbs().minCoeff()) > 0.))
    return false;
  if (moving)
  {
    field.extension().restrict(momentum, body.nodes.velocity);
    if (affine)
      of_matrices->add_to(body.nodes.velocity);
    for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
      body.nodes.velocity.segment<2>(2 * i) /= body.nodes.mass[i];
  }
  return true;
}
} // namespace

void lay_grid(Body<2> &body, const BuildContext &context)
{
  const std::size_t n = body.points.size();
  std::vector<dealii::Point<2>> position(n);
  std::vector<double> volume(n), half_extent(n);
  for (unsigned int p = 0; p < n; ++p)
  {
    const auto point = body.points[p];
    position[p] = point.position();
    half_extent[p] = point.half_extent();
    volume[p] =
        body.material.small_strain() ? point.volume() : point.rest_volume() * determinant(point.gradient());
  }
  // Extrapolation has negative weights, and a node between several poorly filled cells may be left with a
  // negative mass. Then some of these cells have to count as well filled; at last all that hold points do,
  // and masses are positive. Functions that are negative in places are for schemes without inertia, where
  // masses are no more than weights.
  for (double limit = context.settings.fill_limit;; limit *= 0.5)
  {
    body.field.build(context.lattice, context.shape,
                     {position, volume, half_extent, body.boundary.grid_position, body.levels.get()}, limit);
    if (points_to_nodes(body, context.shape.nowhere_negative()))
      break;
    if (limit < 1e-4)
      throw ComputationError("body '" + body.name +
                             "': a node has no positive mass; refine 'Mesh/Cell size'");
  }
  body.nodes.displacement = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.nodes.velocity_of_points = body.nodes.velocity;
  body.nodes.kept.resize(0);
}

std::vector<dealii::Point<2>> places_reached(const Body<2> &body, const Lattice<2> &lattice)
{
  Eigen::VectorXd u;
  body.field.extension().prolongate(body.nodes.displacement, u);
  std::vector<dealii::Point<2>> places(body.points.size());
  for (unsigned int p = 0; p < places.size(); ++p)
  {
    places[p] = body.points[p].position();
    for (unsigned int k = 0; k < body.field.cells().nodes_per_cell(); ++k)
      for (unsigned int d = 0; d < 2; ++d)
        places[p][d] += body.field.at_point(p).values[k] * u[2 * body.field.at_point(p).nodes[k] + d];
    lattice.check_inside(places[p], "material point of body '" + body.name + "'");
  }
  return places;
}

void check_markers(const Body<2> &body, const Lattice<2> &lattice)
{
  for (const dealii::Point<2> &x : body.boundary.position)
    lattice.check_inside(x, "boundary marker of body '" + body.name + "'");
}

void leave_grid(Body<2> &body,
                const StepState<2> &s,
                const std::vector<dealii::Point<2>> &places,
                const BuildContext &context)
{
  const BodyField<2> &field = body.field;
  const bool moving = body.points.layout().has(PointSlot::velocity),
             affine = moving && body.points.layout().has(PointSlot::affine);
  const double pic = context.settings.pic_fraction, h = context.lattice.cell_size();
  const unsigned int n = field.cells().nodes_per_cell();
  Eigen::VectorXd u, v, before;
  field.extension().prolongate(body.nodes.displacement, u);
  if (moving)
  {
    field.extension().prolongate(body.nodes.velocity, v);
    field.extension().prolongate(body.nodes.velocity_of_points, before);
  }
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    auto point = body.points[p];
    const unsigned int *nodes = field.at_point(p).nodes;
    const double *value = field.at_point(p).values;
    const auto *slope = field.at_point(p).slopes;
    dealii::Tensor<1, 2> interpolated, increment;
    dealii::Tensor<2, 2> gradient = unit(), rate, moment, spread;
    for (unsigned int k = 0; k < n; ++k)
    {
      const dealii::Tensor<1, 2> uk({u[2 * nodes[k]], u[2 * nodes[k] + 1]});
      gradient += outer_product(uk, slope[k]);
      if (!moving)
        continue;
      const dealii::Tensor<1, 2> vk({v[2 * nodes[k]], v[2 * nodes[k] + 1]}),
          bk({before[2 * nodes[k]], before[2 * nodes[k] + 1]});
      const dealii::Tensor<1, 2> arm = field.nodes().position(nodes[k]) - point.position();
      interpolated += value[k] * vk;
      increment += value[k] * (vk - bk);
      rate += outer_product(vk, slope[k]);
      moment += value[k] * outer_product(vk, arm);
      spread += value[k] * outer_product(arm, arm);
    }
    point.move_to(context.lattice.off_faces(places[p]));
    point.gradient() = gradient * point.gradient();
    if (body.material.small_strain() && !body.rigid.driven) // what is driven is never stressed
      point.volume() = s.volume[p];
    if (moving)
      point.velocity() = pic * interpolated + (1. - pic) * (point.velocity() + increment);
    if (affine)
    {
      // APIC's B D^-1; hats lose D at a node, where B D^-1 is the velocity gradient anyway (Jiang et al.
      // 2015).
      point.velocity() = interpolated;
      point.affine() = context.shape.degree() > 1 && determinant(spread) > 1e-8 * std::pow(h, 4)
                           ? moment * invert(spread)
                           : rate;
    }
  }
}

template <int dim>
void move_boundary(Body<dim> &body)
{
  for (unsigned int m = 0; m < body.boundary.position.size(); ++m)
    body.boundary.position[m] = body.boundary.grid_position[m] + at_marker(body, m, body.nodes.displacement);
}

template void move_boundary(Body<2> &);
template void move_boundary(Body<3> &);

double grid_distortion(const StepState<2> &s)
{
  double worst = 1.;
  for (const dealii::Tensor<2, 2> &G : s.grid_gradient)
  {
    // Singular values of a 2x2 matrix from its norm and determinant.
    const double sum = G.norm_square(), product = std::abs(determinant(G));
    const double root = std::sqrt(std::max(0., sum * sum - 4. * product * product));
    worst = std::max(worst, std::sqrt((sum + root) / std::max(sum - root, 1e-300)));
  }
  return worst;
}
} // namespace softgrain::mpm
