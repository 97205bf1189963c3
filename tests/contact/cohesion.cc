// SPDX-License-Identifier: LGPL-2.1-or-later
// Coulomb's cone shifted along the normal by cohesive impulses: one contact in closed form, and packings in
// which every solver finds the impulses of Lemke's method, or at least some that obey the shifted conditions.
#include "reference.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/problem_io.h>

#include <iostream>

using namespace softgrain;
using namespace softgrain::contact;

namespace
{
/// W = 2, friction 0.5, cohesion 3: pulled with q_n, sheared with q_t.
void one_contact(const double q_n, const double q_t)
{
  DiagonalDelassus W(2, {2., 0., 0., 2.});
  Problem problem{2, {q_n, q_t}, {0.5}};
  problem.cohesion = {3.};
  std::vector<double> P, w;
  solve(W, problem, SolverSettings(), P, w);
  // Held up to P = -3; slides at 0.5 (P + 3).
  const double normal = std::max(-3., -0.5 * q_n), limit = 0.5 * (normal + 3.),
               tangential = std::clamp(-0.5 * q_t, -limit, limit);
  std::cout << "pulled with " << q_n << ", sheared with " << q_t << ": impulses " << P[0] << ' ' << P[1]
            << ", velocities " << w[0] << ' ' << w[1] << ", as known "
            << verdict(std::abs(P[0] - normal) + std::abs(P[1] - tangential) < 1e-12) << '\n';
}

/// Bodies that are pulled apart and sheared at random.
Problem torn(const BlockDelassus &W, const bool friction)
{
  const unsigned int n = W.n_components();
  Problem problem{n, {}, std::vector<double>(friction ? W.n_contacts() : 0, 0.4)};
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (unsigned int i = 0; i < n * W.n_contacts(); ++i)
    problem.free_velocity.push_back(normal(generator));
  for (unsigned int i = 0; i < W.n_contacts(); ++i)
    problem.cohesion.push_back(i % 3 == 0 ? 0. : 0.2 * (i % 5));
  return problem;
}

/// The problem for P + c, which is Coulomb's.
Problem without_cohesion(const Problem &problem, const Eigen::MatrixXd &W)
{
  Eigen::VectorXd c = Eigen::VectorXd::Zero(problem.free_velocity.size());
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    c[i * problem.n_components] = problem.cohesion[i];
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(problem.free_velocity.data(), c.size()) - W * c;
  return {problem.n_components, std::vector<double>(q.data(), q.data() + q.size()), problem.friction};
}

void packing(const std::string &title, const unsigned int components, const double rigid)
{
  BlockDelassus W = random_bodies(12, 3, components, rigid, 7);
  const Problem problem = torn(W, components > 1);
  const Eigen::MatrixXd dense = Eigen::MatrixXd(W.assemble());
  const Problem shifted = without_cohesion(problem, dense);
  std::cout << title << ":\n";
  for (const auto &[name, algorithm] : algorithms())
  {
    SolverSettings settings;
    settings.algorithm = algorithm;
    settings.tolerance = 1e-10;
    settings.max_sweeps = 200000;
    std::vector<double> P, w;
    const SolverReport report = solve(W, problem, settings, P, w);
    unsigned int pulls = 0;
    std::vector<double> sum = P;
    for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    {
      pulls += P[i * components] < -1e-6;
      sum[i * components] += problem.cohesion[i];
    }
    std::cout << "  " << name << ": converged " << verdict(report.converged || report.limited_by_rounding)
              << ", some pull " << verdict(pulls > 0) << ", violation of the shifted conditions below 1e-7 "
              << verdict(worst_violation(shifted, dense, sum) < 1e-7);
    if (components == 1)
    {
      const Eigen::VectorXd exact =
          lemke(dense, Eigen::Map<const Eigen::VectorXd>(shifted.free_velocity.data(), sum.size()));
      std::cout << ", impulses of Lemke within 1e-7 "
                << verdict(largest_difference(sum, {exact.data(), exact.data() + exact.size()}) < 1e-7);
    }
    std::cout << '\n';
  }
}

void replayed()
{
  BlockDelassus W = random_bodies(6, 2, 2, 1., 5);
  const Problem problem = torn(W, true);
  save_problem("cohesion.h5", W, problem, SolverSettings(), std::vector<double>(24, 0.), "pulled");
  std::vector<double> P, w, again, w_again;
  solve(W, problem, SolverSettings(), P, w);
  replay("cohesion.h5", again, w_again);
  std::cout << "saved and replayed: same cohesion "
            << verdict(load_problem("cohesion.h5").problem.cohesion == problem.cohesion)
            << ", same impulses to the bit " << verdict(P == again) << '\n';
}

void refused()
{
  DiagonalDelassus W(1, {1., 1.});
  for (const std::vector<double> &cohesion : {std::vector<double>{1.}, std::vector<double>{1., -2.}})
    try
    {
      Problem problem{1, {-1., 1.}, {}};
      problem.cohesion = cohesion;
      std::vector<double> P, w;
      solve(W, problem, SolverSettings(), P, w);
      std::cout << "nothing thrown\n";
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}

/// Nothing but prescribed motion on both sides: no impulse, however strong the cohesion.
void prescribed()
{
  DiagonalDelassus W(1, {0., 1.});
  Problem problem{1, {1., 1.}, {}};
  problem.cohesion = {5., 5.};
  std::vector<double> P, w;
  solve(W, problem, SolverSettings(), P, w);
  std::cout << "prescribed on both sides: impulse " << P[0] << ", beside it one that holds with " << P[1]
            << '\n';
}
} // namespace

int main()
{
  one_contact(-2., 1.); // pressed, sticks
  one_contact(4., 0.5); // pulled, sticks
  one_contact(4., 9.);  // pulled, slides
  one_contact(8., 1.);  // torn apart
  packing("without friction", 1, 0.);
  packing("without friction, loose bodies", 1, 10.);
  packing("in the plane", 2, 0.);
  packing("in the plane, loose bodies", 2, 1e2);
  packing("in space", 3, 0.);
  replayed();
  refused();
  prescribed();
}
