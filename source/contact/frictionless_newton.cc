// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/contact/active_system.h>
#include <softgrain/contact/frictionless_newton.h>
#include <softgrain/contact/residual.h>

#include <limits>

namespace softgrain::contact
{
namespace
{
std::vector<double> to_vector(const Eigen::VectorXd &x)
{
  return std::vector<double>(x.data(), x.data() + x.size());
}
} // namespace

FrictionlessNewton::FrictionlessNewton(const Matrix &W,
                                       const Problem &problem,
                                       const std::vector<double> &compliance,
                                       const SolverSettings &settings)
    : W(W)
    , problem(problem)
    , compliance(compliance)
    , settings(settings)
    , q(Eigen::Map<const Eigen::VectorXd>(problem.free_velocity.data(), problem.free_velocity.size()))
    , diagonal(W.diagonal())
    , speed(approach_speed(problem, compliance))
{
}

double FrictionlessNewton::residual(const Eigen::VectorXd &P) const
{
  const Eigen::VectorXd w = W * P + q;
  return natural_residual(problem, compliance, to_vector(P), to_vector(w));
}

bool FrictionlessNewton::solve_active(const std::vector<unsigned int> &active,
                                      const double epsilon,
                                      const Eigen::VectorXd &right_hand_side,
                                      Eigen::VectorXd &solution) const
{
  solution.resize(0);
  if (active.empty())
    return true;
  std::vector<int> local(q.size(), -1);
  std::size_t n_entries = 0;
  for (unsigned int a = 0; a < active.size(); ++a)
    local[active[a]] = a;
  for (const unsigned int i : active)
    for (Matrix::InnerIterator entry(W, i); entry; ++entry)
      n_entries += local[entry.col()] >= 0;
  ActiveSystem system(active.size(), n_entries, true);
  for (unsigned int a = 0; a < active.size(); ++a)
    for (Matrix::InnerIterator entry(W, active[a]); entry; ++entry)
      if (const int b = local[entry.col()]; b >= 0)
        system.add(a, b, a == unsigned(b) ? entry.value() + epsilon * diagonal[active[a]] : entry.value());
  return system.solve_symmetric(right_hand_side, solution);
}

bool FrictionlessNewton::pivot(const double epsilon, Eigen::VectorXd &P, SolverReport &report) const
{
  const unsigned int n = q.size();
  const Eigen::VectorXd center = P;
  const Eigen::VectorXd q_prox = q - epsilon * diagonal.cwiseProduct(center);
  const double zero = 0.01 * settings.tolerance * speed;
  // Velocities say nothing of the active set where bodies are out of balance: see frictional_newton().
  std::vector<char> closed(n);
  const bool warm = P.maxCoeff() > 0.;
  for (unsigned int i = 0; i < n; ++i)
    closed[i] = compliance[i] > 0. && (warm ? P[i] > 0. : q[i] < 0.);

  Eigen::VectorXd x, solution;
  std::vector<unsigned int> active;
  unsigned int fewest = n + 1, patience = 3;
  for (; report.newton_iterations < settings.max_newton_iterations; ++report.newton_iterations)
  {
    stop_if_interrupted();
    active.clear();
    for (unsigned int i = 0; i < n; ++i)
      if (closed[i])
        active.push_back(i);
    Eigen::VectorXd b(active.size());
    for (unsigned int a = 0; a < active.size(); ++a)
      b[a] = -q_prox[active[a]];
    if (!solve_active(active, epsilon, b, solution))
      return false;
    x = Eigen::VectorXd::Zero(n);
    for (unsigned int a = 0; a < active.size(); ++a)
      x[active[a]] = solution[a];
    const Eigen::VectorXd w = W * x + q_prox; // x is 0 where the proximal term would add to an open contact

    std::vector<unsigned int> wrong;
    for (unsigned int i = 0; i < n; ++i)
      if (compliance[i] > 0. && (closed[i] ? compliance[i] * x[i] : w[i]) < -zero)
        wrong.push_back(i);
    if (wrong.empty())
    {
      ++report.newton_iterations;
      P = x.cwiseMax(0.);
      return true;
    }
    // Exchange all wrong ones while their number falls or patience lasts, otherwise only the last: that rule
    // (Murty's) ends for a positive definite matrix.
    if (wrong.size() < fewest)
    {
      fewest = wrong.size();
      patience = 3;
    }
    else if (patience > 0)
      --patience;
    else
      wrong.erase(wrong.begin(), wrong.end() - 1);
    for (const unsigned int i : wrong)
      closed[i] = !closed[i];
  }
  return false;
}

void FrictionlessNewton::descend(const double epsilon, Eigen::VectorXd &P, SolverReport &report) const
{
  for (unsigned int repetition = 0; repetition < 5; ++repetition)
    for (unsigned int i = 0; i < P.size(); ++i)
      if (compliance[i] > 0.)
      {
        const double w = W.row(i).dot(P) + q[i];
        P[i] = std::max(0., P[i] - w / compliance[i]);
      }
  const Eigen::VectorXd gradient = W * P + q;
  std::vector<unsigned int> active;
  for (unsigned int i = 0; i < P.size(); ++i)
    if (P[i] > 0.)
      active.push_back(i);
  Eigen::VectorXd b(active.size()), solution;
  for (unsigned int a = 0; a < active.size(); ++a)
    b[a] = -gradient[active[a]];
  ++report.newton_iterations;
  if (!solve_active(active, epsilon, b, solution))
    return;
  for (double factor = 1.; factor > 1e-4; factor *= 0.5)
  {
    Eigen::VectorXd next = P;
    for (unsigned int a = 0; a < active.size(); ++a)
      next[active[a]] = std::max(0., P[active[a]] + factor * solution[a]);
    const Eigen::VectorXd step = next - P;
    // the change of φ itself, not the difference of two φ: that would be lost in rounding near the solution
    if (gradient.dot(step) + 0.5 * step.dot(W * step) < 0.)
    {
      P = next;
      return;
    }
  }
}

double FrictionlessNewton::solve(std::vector<double> &impulses, SolverReport &report) const
{
  Eigen::VectorXd P = Eigen::Map<const Eigen::VectorXd>(impulses.data(), impulses.size());
  double best = residual(P), epsilon = 1e-10, last = std::numeric_limits<double>::infinity();
  while (best > settings.tolerance && report.newton_iterations < settings.max_newton_iterations)
  {
    Eigen::VectorXd next = P;
    const bool ended = pivot(epsilon, next, report);
    double here = ended ? residual(next) : std::numeric_limits<double>::infinity();
    if (!ended || !(here < 0.5 * last))
    {
      if (!ended && epsilon < 1e-6)
      {
        epsilon *= 100.;
        ++report.regularised;
      }
      if (!ended || !(here < best))
        next = P;
      descend(epsilon, next, report);
      here = residual(next);
    }
    const bool stalled = !(here < 0.5 * last);
    last = here;
    P = next;
    if (here < best)
    {
      best = here;
      impulses = to_vector(P);
    }
    if (stalled && best <= rounding_floor(W, impulses, speed))
      break;
  }
  return best;
}
} // namespace softgrain::contact
