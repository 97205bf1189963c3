// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/whole_rotation.h>

#include <algorithm>

namespace softgrain::mpm
{
Eigen::VectorXd whole_rotation(const Body<2> &body)
{
  dealii::Tensor<1, 2> moment;
  std::vector<dealii::Point<2>> place(body.mass.size());
  for (unsigned int i = 0; i < body.mass.size(); ++i)
  {
    place[i] = body.field.position(body.field.node_of_independent(i));
    for (unsigned int d = 0; d < 2; ++d)
      place[i][d] += body.displacement[2 * i + d];
    moment += body.mass[i] * (place[i] - dealii::Point<2>());
  }
  const dealii::Point<2> center(moment / body.mass.sum());
  Eigen::VectorXd rotation(body.field.n_dofs());
  double inertia = 0.;
  for (unsigned int i = 0; i < body.mass.size(); ++i)
  {
    const dealii::Tensor<1, 2> arm = place[i] - center;
    rotation[2 * i] = -body.mass[i] * arm[1];
    rotation[2 * i + 1] = body.mass[i] * arm[0];
    inertia += body.mass[i] * arm.norm_square();
  }
  return rotation / inertia;
}

double rotation_resistance(const Body<2> &body)
{
  double pressure_area = 0.;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    pressure_area -= 0.5 * body.points[p].rest_volume() * trace(body.points[p].stress());
  return 2.5 * std::max(0., pressure_area) + 1e-3 * body.law->young_modulus() * body.rest_area;
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
