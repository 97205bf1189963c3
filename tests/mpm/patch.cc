// SPDX-License-Identifier: LGPL-2.1-or-later
// Patch test: a block between plates, shifted against the mesh by fractions of a cell. Stress is uniform, and
// neither its error nor the condition number of the system depends on how the mesh cuts the block.
#include "scene_of.h"

#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <Eigen/Eigenvalues>

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double E = 1e6, nu = 0.3, stretch = 0.8;

/// Cauchy stress under the plates for a block with free sides: tau_xx = 0 gives the lateral stretch.
double exact_stress()
{
  const double mu = E / 2. / (1. + nu), lambda = E * nu / (1. + nu) / (1. - 2. * nu);
  double a = 1.;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double f = mu * (a * a - 1.) + lambda * std::log(a * stretch);
    a -= f / (2. * mu * a + lambda / a);
  }
  return (mu * (stretch * stretch - 1.) + lambda * std::log(a * stretch)) / (a * stretch);
}

/// Condition of the scaled M + dt^2 K for a step of 20 CFL, as Jacobi scaling leaves it.
double condition(const mpm::MpmModel &model)
{
  const mpm::Body<2> &body = model.bodies()[0];
  SystemMatrix matrix;
  lay_out_stiffness(body.field, matrix, false);
  matrix.set_zero();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(body.field.n_dofs());
  mpm::StepState<2> at;
  mpm::evaluate_stress(body, zero, zero, {0., true, 0.}, at);
  mpm::add_stiffness(body, at, std::pow(20. * model.cfl_step(), 2), matrix);
  matrix.add_mass<2>(body.nodes.mass, 1.);
  Eigen::MatrixXd A = Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  A = scale.asDiagonal() * A * scale.asDiagonal();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
  return values.maxCoeff() / values.minCoeff();
}
} // namespace

int main(int argc, char **)
{
  const double exact = exact_stress();
  for (const std::string shape : {"linear", "gimp", "bspline"})
  {
    double largest_condition = 0., smallest_condition = 1e300, worst_rms = 0., worst_force = 0.;
    for (unsigned int k = 0; k < 5; ++k)
    {
      const double shift = 0.2e-3 * k;
      std::ostringstream center, bottom, top;
      center.precision(12);
      center << "Bodies/block/Center=" << shift << ", " << 0.7 * shift;
      bottom << "Walls/bottom/Point=0, " << -4e-3 + 0.7 * shift;
      top << "Walls/top/Point=0, " << 4e-3 + 0.7 * shift;
      const auto model =
          shipped_scene("verification/patch_test.prm",
                        {"Material points/Shape function=" + shape, center.str(), bottom.str(), top.str()});
      const double number = condition(*model);
      run_until(*model, 1.);
      const Snapshot<2> now = model->snapshot();
      double sum = 0., area = 0.;
      for (unsigned int p = 0; p < now.points.position.size(); ++p)
      {
        const auto &s = now.points.stress[p];
        sum += now.points.size[p] * (s[0][0] * s[0][0] + std::pow(s[1][1] - exact, 2));
        area += now.points.size[p];
      }
      const double rms = std::sqrt(sum / area) / std::abs(exact);
      const double width = model->solid_area() / (8e-3 * stretch);
      const double force = model->walls()[0].normal_force / (-exact * width) - 1.;
      if (argc > 1)
        std::cout << shape << " shift " << shift << ": stress error " << 100. * rms << " %, force error "
                  << 100. * force << " %, condition " << number << '\n';
      worst_rms = std::max(worst_rms, rms);
      worst_force = std::max(worst_force, std::abs(force));
      largest_condition = std::max(largest_condition, number);
      smallest_condition = std::min(smallest_condition, number);
    }
    std::cout << shape << ": stress error at most " << 100. * worst_rms << " %, force error at most "
              << 100. * worst_force << " %, condition " << smallest_condition << " to " << largest_condition
              << '\n';
  }
}
