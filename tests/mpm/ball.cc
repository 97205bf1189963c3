// SPDX-License-Identifier: LGPL-2.1-or-later
// A ball that a grid cuts: its points have its volume, its centre and its moment of inertia, its surface has
// Euler's characteristic and nearly its area. Under an affine motion no node feels a force but through the
// surface: the force does on rigid motions no work, and the virial is the mean stress. The stiffness of
// neo-Hookean and Hencky balls is what differences of forces are.
#include "ball.h"

#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <iostream>
#include <random>

using namespace softgrain;

namespace
{
void shape_of(const double cell)
{
  const Ball ball(2., cell, "neo_hookean");
  double volume = 0., square = 0.;
  dealii::Tensor<1, 3> middle;
  for (unsigned int p = 0; p < ball.body.points.size(); ++p)
  {
    const auto point = ball.body.points[p];
    volume += point.rest_volume();
    middle += point.rest_volume() * (point.position() - ball.sphere.center);
    square += point.rest_volume() * (point.position() - ball.sphere.center).norm_square();
  }
  const double exact = ball.sphere.volume();
  const TriangulatedSurface surface = ball.sphere.surface(cell);
  double area = 0.;
  for (const auto &t : surface.triangles)
    area += 0.5 * dealii::cross_product_3d(surface.vertices[t[1]] - surface.vertices[t[0]],
                                           surface.vertices[t[2]] - surface.vertices[t[0]])
                      .norm();
  const double of_parts = exact * (0.25 * cell) * (0.25 * cell); // what points have about their own middle
  std::cout << "cells " << 2. / cell
            << " in the radius: volume off by less than rounding: " << (std::abs(volume / exact - 1.) < 1e-12)
            << ", centre by less than 1e-4 cells: " << (middle.norm() / volume < 1e-4 * cell)
            << ", inertia by less than .3 %: "
            << (std::abs((square + of_parts) / (0.6 * 4. * exact) - 1.) < 3e-3) << ", Euler "
            << surface.vertices.size() + surface.triangles.size() - 3 * surface.triangles.size() / 2
            << ", area " << area / (4. * dealii::numbers::PI * 4.) << '\n';
}

Eigen::VectorXd force_of(const mpm::Body<3> &body, const Eigen::VectorXd &u, mpm::StepState<3> &points)
{
  mpm::Trial trial;
  trial.tangent = true;
  Eigen::VectorXd force;
  if (!mpm::evaluate_stress(body, u, u, trial, points).good())
    std::cout << "inside out\n";
  mpm::internal_force(body, points, force);
  return force;
}

void stiffness_of(const std::string &law)
{
  const Ball ball(2., 0.7, law);
  const mpm::Body<3> &body = ball.body;
  std::mt19937 generator(7);
  std::uniform_real_distribution<> uniform(-1., 1.);
  const auto random = [&](const double size)
  {
    Eigen::VectorXd v(body.field.n_dofs());
    for (double &x : v)
      x = size * uniform(generator);
    return v;
  };
  const Eigen::VectorXd u = random(0.05), d = random(1.);
  mpm::StepState<3> at, beside;
  const Eigen::VectorXd force = force_of(body, u, at);
  SystemMatrix matrix;
  mpm::lay_out_stiffness(body.field, matrix, false);
  mpm::add_stiffness(body, at, 1., matrix);
  const Eigen::VectorXd Kd = matrix.lower().selfadjointView<Eigen::Lower>() * d;
  const double step = 1e-5;
  const Eigen::VectorXd slope =
      (force_of(body, u - step * d, beside) - force_of(body, u + step * d, beside)) / (2. * step);
  dealii::Tensor<1, 3> sum, torque;
  for (unsigned int i = 0; i < body.field.n_independent(); ++i)
  {
    dealii::Tensor<1, 3> f, x = body.field.place(i) - dealii::Point<3>();
    for (unsigned int e = 0; e < 3; ++e)
    {
      f[e] = force[3 * i + e];
      x[e] += u[3 * i + e];
    }
    sum += f;
    torque += dealii::cross_product_3d(x, f);
  }
  std::cout << law << ": stiffness off by less than a hundred-millionth: "
            << ((Kd - slope).norm() < 1e-8 * slope.norm())
            << ", force and torque of the whole below rounding: "
            << (sum.norm() + torque.norm() < 1e-12 * force.norm() * force.size()) << '\n';
}
} // namespace

int main()
{
  shape_of(0.7);
  shape_of(0.35);
  for (const std::string law : {"neo_hookean", "hencky"})
    stiffness_of(law);
}
