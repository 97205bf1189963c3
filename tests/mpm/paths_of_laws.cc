// SPDX-License-Identifier: LGPL-2.1-or-later
// A ball in space that is deformed alike everywhere, step by step, with laws that remember: its points keep
// what a step has come to, and stress, plastic strain and what is lost are those of the closed forms.
// Triaxial compression at constant volume with hardening, there and back; a powder pressed from all sides; a
// Maxwell solid that is stretched at once and held.
#include "ball.h"

#include <softgrain/mpm/stepping/keep_points.h>
#include <softgrain/mpm/stepping/stress.h>

#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
using Tensor = dealii::Tensor<2, 3>;

Tensor diagonal(const double across, const double along)
{
  Tensor F;
  F[0][0] = F[1][1] = across;
  F[2][2] = along;
  return F;
}

/// Deforms the ball to F in a step of @p dt, and keeps it. @return what the law lost per rest volume
double go_to(Ball &ball, const Tensor &F, const double dt)
{
  mpm::Body<3> &body = ball.body;
  Eigen::VectorXd to(body.nodes.displacement.size());
  for (unsigned int i = 0; i < body.field.n_independent(); ++i)
  {
    const dealii::Tensor<1, 3> arm = body.field.place(i) - ball.sphere.center, u = F * arm - arm;
    for (unsigned int d = 0; d < 3; ++d)
      to[3 * i + d] = u[d];
  }
  mpm::StepState<3> points;
  mpm::Trial trial;
  trial.tangent = true;
  trial.dt = dt;
  if (!mpm::evaluate_stress(body, to, Eigen::VectorXd(to - body.nodes.displacement), trial, points).good())
    std::cout << "refused\n";
  const mpm::WorkOfLaw work = mpm::keep_points(points, body);
  body.nodes.displacement = to;
  return work.loss / body.rest.area;
}

/// The largest relative distance of what @p value finds in all points from what is expected.
template <class Value>
std::string off(const Ball &ball, const double expected, const Value &value)
{
  double worst = 0.;
  for (unsigned int p = 0; p < ball.body.points.size(); ++p)
    worst = std::max(worst, std::abs(value(ball.body.points[p]) / expected - 1.));
  return worst < 1e-8 ? "below 1e-8" : std::to_string(worst);
}

double axial_difference(const mpm::PointView<3> &point)
{
  return point.stress()[2][2] - point.stress()[0][0];
}

double last_of_history(const Ball &ball, const mpm::PointView<3> &point)
{
  return point.history()[ball.law->n_history() - 1];
}

/// Cylinders of constant volume: the von Mises stress is 3 mu times the elastic part of the strain.
void metal()
{
  Ball ball(2., 0.7, "j2_plastic", 0.3, 0., {{"Yield stress", "0.02"}, {"Hardening modulus", "0.1"}});
  const double three_mu = 1.5 / 1.3, yield = 0.02, hardening = 0.1, end = 0.2;
  double lost = 0.;
  for (unsigned int step = 1; step <= 20; ++step)
    lost += go_to(ball, diagonal(std::exp(0.005 * step), std::exp(-0.01 * step)), 1.);
  const double alpha = (three_mu * end - yield) / (three_mu + hardening);
  const auto plastic = [&](const mpm::PointView<3> &point) { return last_of_history(ball, point); };
  std::cout << "metal pressed: stress off by " << off(ball, -(yield + hardening * alpha), axial_difference)
            << ", plastic strain by " << off(ball, alpha, plastic) << ", lost by "
            << off(ball, yield * alpha + 0.5 * hardening * alpha * alpha,
                   [lost](const mpm::PointView<3> &) { return lost; })
            << '\n';
  // Back: elastic over twice the stress, then the other way round.
  for (unsigned int step = 0; step <= 20; ++step)
    go_to(ball, diagonal(std::exp(0.1 - 0.005 * step), std::exp(0.01 * step - 0.2)), 1.);
  const double sum = alpha + (three_mu * end - 2. * (yield + hardening * alpha)) / (three_mu + hardening);
  std::cout << "and back: stress off by " << off(ball, yield + hardening * sum, axial_difference)
            << ", plastic strain by " << off(ball, sum, plastic) << '\n';
}

void powder()
{
  Ball ball(2., 0.7, "drucker_prager", 0.3, 0.,
            {{"Cohesion", "0.002"}, {"Friction", "0.6"}, {"Cap start", "0.005"}, {"Cap pressure", "0.012"}});
  for (unsigned int step = 1; step <= 10; ++step)
    go_to(ball, diagonal(std::exp(-0.005 * step), std::exp(-0.005 * step)), 1.);
  const double bulk = 1. / (3. * (1. - 2. * 0.3));
  std::cout << "powder pressed from all sides: pressure off by "
            << off(ball, 0.012, [](const mpm::PointView<3> &point) { return -trace(point.stress()) / 3.; })
            << ", compaction by "
            << off(ball, 0.15 - 0.012 / bulk,
                   [&](const mpm::PointView<3> &point) { return point.history()[ball.law->n_history() - 2]; })
            << '\n';
}

void polymer()
{
  Ball ball(2., 0.7, "maxwell", 0.3, 0., {{"Shares", "0.5, 0.3"}, {"Relaxation times", "0.5, 4"}});
  const Tensor stretched = diagonal(0.9, 1.3);
  // At once, and no time goes by.
  go_to(ball, stretched, 0.);
  const double at_once = axial_difference(ball.body.points[0]);
  for (unsigned int step = 0; step < 4; ++step)
    go_to(ball, stretched, 0.4);
  std::cout << "polymer held: stress at once off by "
            << off(ball, at_once / (std::log(1.3 / 0.9) / 1.3), [](const mpm::PointView<3> &) { return 1.; })
            << ", later by "
            << off(ball, at_once * (0.2 + 0.5 * std::exp(-1.6 / 0.5) + 0.3 * std::exp(-1.6 / 4.)),
                   axial_difference)
            << '\n';
}
} // namespace

int main()
{
  metal();
  powder();
  polymer();
}
