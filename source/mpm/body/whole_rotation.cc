// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/whole_rotation.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace softgrain::mpm
{
namespace
{
/// Places of the independent nodes for a displacement since the grid was laid, and their centre of mass.
template <int dim>
std::vector<dealii::Point<dim>>
places(const Body<dim> &body, const Eigen::VectorXd &displacement, dealii::Point<dim> &center)
{
  dealii::Tensor<1, dim> moment;
  std::vector<dealii::Point<dim>> place(body.nodes.mass.size());
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    place[i] = body.field.place(i);
    for (unsigned int d = 0; d < dim; ++d)
      place[i][d] += displacement[dim * i + d];
    moment += body.nodes.mass[i] * (place[i] - dealii::Point<dim>());
  }
  center = dealii::Point<dim>(moment / body.nodes.mass.sum());
  return place;
}

/// Mass of every node times its arm about the centre of mass, turned by 90 degrees about every axis; and the
/// rotary @p inertia about each.
template <int dim>
WholeRotation<dim>
moment_of_masses(const Body<dim> &body, const Eigen::VectorXd &displacement, Turn<dim> &inertia)
{
  dealii::Point<dim> center;
  const std::vector<dealii::Point<dim>> place = places(body, displacement, center);
  WholeRotation<dim> moment = WholeRotation<dim>::Zero(body.field.n_dofs(), n_turns<dim>);
  inertia.setZero();
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    const dealii::Tensor<1, dim> arm = place[i] - center;
    for (int axis = 0; axis < n_turns<dim>; ++axis)
    {
      const unsigned int from = dim == 2 ? 0 : (axis + 1) % 3, to = dim == 2 ? 1 : (axis + 2) % 3;
      moment(dim * i + from, axis) = -body.nodes.mass[i] * arm[to];
      moment(dim * i + to, axis) = body.nodes.mass[i] * arm[from];
      inertia[axis] += body.nodes.mass[i] * (arm[from] * arm[from] + arm[to] * arm[to]);
    }
  }
  return moment;
}

template <int dim>
void divide(WholeRotation<dim> &moment, const Turn<dim> &inertia)
{
  for (int axis = 0; axis < n_turns<dim>; ++axis)
    moment.col(axis) /= inertia[axis];
}
} // namespace

template <int dim>
WholeRotation<dim> whole_rotation(const Body<dim> &body)
{
  Turn<dim> inertia;
  WholeRotation<dim> rotation = moment_of_masses(body, body.nodes.displacement, inertia);
  divide<dim>(rotation, inertia);
  return rotation;
}

template <int dim>
WholeRotation<dim> whole_rotation(const Body<dim> &body, const Eigen::VectorXd &way)
{
  Turn<dim> inertia, on_the_way;
  moment_of_masses(body, body.nodes.displacement, inertia);
  WholeRotation<dim> rotation = moment_of_masses<dim>(body, body.nodes.displacement + way, on_the_way);
  divide<dim>(rotation, inertia);
  return rotation;
}

template <int dim>
double rotary_inertia(const Body<dim> &body, const Eigen::VectorXd &r)
{
  // r is M w / I for the field w of a unit rotation, so that rᵀ M⁻¹ r = 1/I.
  double inverse = 0.;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    inverse += r.segment<dim>(dim * i).squaredNorm() / body.nodes.mass[i];
  return 1. / inverse;
}

template <>
Eigen::VectorXd turned<2>(const Eigen::VectorXd &vectors, const Turn<2> &turn)
{
  const double c = std::cos(turn[0]), s = std::sin(turn[0]);
  Eigen::VectorXd result(vectors.size());
  for (Eigen::Index i = 0; i + 1 < vectors.size(); i += 2)
  {
    result[i] = c * vectors[i] - s * vectors[i + 1];
    result[i + 1] = s * vectors[i] + c * vectors[i + 1];
  }
  return result;
}

template <>
Eigen::VectorXd turned<3>(const Eigen::VectorXd &vectors, const Turn<3> &turn)
{
  const double angle = turn.norm();
  if (angle == 0.)
    return vectors;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  Eigen::VectorXd result(vectors.size());
  for (Eigen::Index i = 0; i + 2 < vectors.size(); i += 3)
    result.segment<3>(i) = rotation * vectors.segment<3>(i);
  return result;
}

void turn_along_circles(const Body<2> &body,
                        const Eigen::VectorXd &r,
                        const Eigen::VectorXd &from,
                        Eigen::VectorXd &step)
{
  const double angle = r.dot(step);
  if (angle == 0.)
    return;
  dealii::Point<2> center;
  const std::vector<dealii::Point<2>> place = places(body, from, center);
  const double along = std::cos(angle) - 1., across = std::sin(angle) - angle;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
  {
    const dealii::Tensor<1, 2> arm = place[i] - center;
    step[2 * i] += along * arm[0] - across * arm[1];
    step[2 * i + 1] += along * arm[1] + across * arm[0];
  }
}

template <int dim>
double pressure_area(const Body<dim> &body, const StepState<dim> &s)
{
  double sum = 0.;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    sum -= s.volume[p] * trace(s.stress[p]) / dim;
  return sum;
}

template <int dim>
void spread_imbalance(const Body<dim> &body, const Eigen::VectorXd &impulse, Eigen::VectorXd &velocity)
{
  dealii::Tensor<1, dim> sum;
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      sum[d] += impulse[dim * i + d];
  sum /= body.nodes.mass.sum();
  for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      velocity[dim * i + d] += sum[d];
}

template WholeRotation<2> whole_rotation(const Body<2> &);
template WholeRotation<3> whole_rotation(const Body<3> &);
template WholeRotation<2> whole_rotation(const Body<2> &, const Eigen::VectorXd &);
template WholeRotation<3> whole_rotation(const Body<3> &, const Eigen::VectorXd &);
template double rotary_inertia(const Body<2> &, const Eigen::VectorXd &);
template double rotary_inertia(const Body<3> &, const Eigen::VectorXd &);
template double pressure_area(const Body<2> &, const StepState<2> &);
template double pressure_area(const Body<3> &, const StepState<3> &);
template void spread_imbalance(const Body<2> &, const Eigen::VectorXd &, Eigen::VectorXd &);
template void spread_imbalance(const Body<3> &, const Eigen::VectorXd &, Eigen::VectorXd &);
} // namespace softgrain::mpm
