// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/whole_rotation.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace softgrain::mpm
{
namespace
{
/// Places of the independent nodes for a displacement since the grid was laid, and their centre of mass.
std::vector<dealii::Point<2>>
places(const Body<2> &body, const Eigen::VectorXd &displacement, dealii::Point<2> &center)
{
  dealii::Tensor<1, 2> moment;
  std::vector<dealii::Point<2>> place(body.mass.size());
  for (unsigned int i = 0; i < body.mass.size(); ++i)
  {
    place[i] = body.field.position(body.field.node_of_independent(i));
    for (unsigned int d = 0; d < 2; ++d)
      place[i][d] += displacement[2 * i + d];
    moment += body.mass[i] * (place[i] - dealii::Point<2>());
  }
  center = dealii::Point<2>(moment / body.mass.sum());
  return place;
}

/// Mass of every node times its arm about the centre of mass, turned by 90 degrees; and the rotary
/// @p inertia.
Eigen::VectorXd moment_of_masses(const Body<2> &body, const Eigen::VectorXd &displacement, double &inertia)
{
  dealii::Point<2> center;
  const std::vector<dealii::Point<2>> place = places(body, displacement, center);
  Eigen::VectorXd moment(body.field.n_dofs());
  for (unsigned int i = 0; i < body.mass.size(); ++i)
  {
    const dealii::Tensor<1, 2> arm = place[i] - center;
    moment[2 * i] = -body.mass[i] * arm[1];
    moment[2 * i + 1] = body.mass[i] * arm[0];
    inertia += body.mass[i] * arm.norm_square();
  }
  return moment;
}
} // namespace

Eigen::VectorXd whole_rotation(const Body<2> &body)
{
  double inertia = 0.;
  const Eigen::VectorXd rotation = moment_of_masses(body, body.displacement, inertia);
  return rotation / inertia;
}

Eigen::VectorXd whole_rotation(const Body<2> &body, const Eigen::VectorXd &way)
{
  double inertia = 0.;
  moment_of_masses(body, body.displacement, inertia);
  double on_the_way = 0.;
  return moment_of_masses(body, body.displacement + way, on_the_way) / inertia;
}

double rotary_inertia(const Body<2> &body, const Eigen::VectorXd &r)
{
  // r is M w / I for the field w of a unit rotation, so that rᵀ M⁻¹ r = 1/I.
  double inverse = 0.;
  for (unsigned int i = 0; i < body.mass.size(); ++i)
    inverse += r.segment<2>(2 * i).squaredNorm() / body.mass[i];
  return 1. / inverse;
}

Eigen::VectorXd turned(const Eigen::VectorXd &vectors, const double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::VectorXd result(vectors.size());
  for (Eigen::Index i = 0; i + 1 < vectors.size(); i += 2)
  {
    result[i] = c * vectors[i] - s * vectors[i + 1];
    result[i + 1] = s * vectors[i] + c * vectors[i + 1];
  }
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
  for (unsigned int i = 0; i < body.mass.size(); ++i)
  {
    const dealii::Tensor<1, 2> arm = place[i] - center;
    step[2 * i] += along * arm[0] - across * arm[1];
    step[2 * i + 1] += along * arm[1] + across * arm[0];
  }
}

double pressure_area(const Body<2> &body, const StepState<2> &s)
{
  double sum = 0.;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    sum -= 0.5 * s.volume[p] * trace(s.stress[p]);
  return sum;
}

void spread_imbalance(const Body<2> &body, const Eigen::VectorXd &impulse, Eigen::VectorXd &velocity)
{
  dealii::Tensor<1, 2> sum;
  for (unsigned int i = 0; i < body.mass.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      sum[d] += impulse[2 * i + d];
  sum /= body.mass.sum();
  for (unsigned int i = 0; i < body.mass.size(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      velocity[2 * i + d] += sum[d];
}
} // namespace softgrain::mpm
