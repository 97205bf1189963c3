// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/frictional_newton.h>
#include <softgrain/contact/frictionless_newton.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/residual.h>

#include <algorithm>

namespace softgrain::contact
{
double newton_active_set(const Eigen::SparseMatrix<double, Eigen::RowMajor> &W,
                         const Problem &problem,
                         const std::vector<double> &compliance,
                         const SolverSettings &settings,
                         std::vector<double> &impulses,
                         SolverReport &report)
{
  if (problem.n_components == 1)
    return FrictionlessNewton(W, problem, compliance, settings).solve(impulses, report);
  if (problem.n_components == 2)
    return frictional_newton<2>(W, problem, compliance, settings, impulses, report);
  return frictional_newton<3>(W, problem, compliance, settings, impulses, report);
}

template <class Operator>
SolverReport solve(Operator &op,
                   const Problem &problem,
                   const SolverSettings &settings,
                   std::vector<double> &impulses,
                   std::vector<double> &velocities)
{
  // Sweeps first in any case: they cost little, find most of the active set and check the input.
  SolverSettings sweeping = settings;
  if (settings.algorithm == Algorithm::active_set)
    sweeping.max_sweeps = std::min(settings.max_sweeps, 10u);
  else if (settings.algorithm == Algorithm::automatic &&
           problem.free_velocity.size() <= settings.max_newton_components)
    sweeping.max_sweeps = std::min(settings.max_sweeps, settings.sweeps_before_newton);
  SolverReport report = gauss_seidel(op, problem, sweeping, impulses, velocities);
  if (report.converged || sweeping.max_sweeps == settings.max_sweeps)
    return report;

  const auto W = op.assemble();
  const std::vector<double> compliance = contact_compliance(op);
  unsigned int chunk = 50;
  std::vector<double> trial;
  while (!report.converged)
  {
    // Each round has the whole budget of iterations, but there are few rounds: chunk doubles when Newton
    // fails.
    SolverReport newton;
    trial = impulses;
    const double before = report.residual;
    const double after = newton_active_set(W, problem, compliance, settings, trial, newton);
    report.newton_iterations += newton.newton_iterations;
    report.regularised += newton.regularised;
    if (after < before)
    {
      report.accelerated = true;
      impulses = trial;
      compute_velocities(op, problem, impulses, velocities);
      report.residual = natural_residual(problem, compliance, impulses, velocities);
      report.converged = report.residual <= settings.tolerance;
      report.prescribed_approach = prescribed_approach(problem, compliance, velocities);
    }
    if (report.converged || report.sweeps >= settings.max_sweeps)
      break;
    if (!(after < 0.1 * before))
      chunk *= 2;
    // Polishing, or a better start for the next round. Sweeps may leave a good iterate of an ill-conditioned
    // problem, so the better one of both ends is kept.
    sweeping.max_sweeps = std::min(chunk, settings.max_sweeps - report.sweeps);
    const double reached = report.residual;
    std::vector<double> polished = impulses, polished_velocities;
    const SolverReport more = gauss_seidel(op, problem, sweeping, polished, polished_velocities);
    report.sweeps += more.sweeps;
    if (more.residual <= reached || !report.accelerated || report.sweeps < settings.max_sweeps)
    {
      impulses = std::move(polished);
      velocities = std::move(polished_velocities);
      report.residual = more.residual;
      report.converged = more.converged;
      report.prescribed_approach = more.prescribed_approach;
    }
  }
  return report;
}

#define SOFTGRAIN_INSTANTIATE(Operator)                                                                      \
  template SolverReport solve(Operator &, const Problem &, const SolverSettings &, std::vector<double> &,    \
                              std::vector<double> &);
SOFTGRAIN_INSTANTIATE(DiagonalDelassus)
SOFTGRAIN_INSTANTIATE(BlockDelassus)
SOFTGRAIN_INSTANTIATE(MassDelassus)
#undef SOFTGRAIN_INSTANTIATE
} // namespace softgrain::contact
