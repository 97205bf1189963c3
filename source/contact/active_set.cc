// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/active_system.h>
#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/frictional_newton.h>
#include <softgrain/contact/frictionless_newton.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/path_following.h>
#include <softgrain/contact/residual.h>
#include <softgrain/contact/shifted_cones.h>

#include <algorithm>

namespace softgrain::contact
{
namespace
{
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Solution without friction, the start of friction_continuation(): tangents 0.
std::vector<double> without_friction(const Matrix &W,
                                     const Problem &problem,
                                     const SolverSettings &settings,
                                     SolverReport &report)
{
  const unsigned int n = problem.n_components, n_contacts = problem.n_contacts();
  Problem normal{1, std::vector<double>(n_contacts), {}};
  std::vector<double> compliance(n_contacts), P(n_contacts, 0.), result(n * n_contacts, 0.);
  std::vector<Eigen::Triplet<double>> entries;
  double largest = 0.;
  for (unsigned int i = 0; i < n_contacts; ++i)
  {
    normal.free_velocity[i] = problem.free_velocity[i * n];
    for (Matrix::InnerIterator entry(W, i * n); entry; ++entry)
      if (entry.col() % n == 0)
        entries.emplace_back(i, entry.col() / n, entry.value());
    compliance[i] = W.coeff(i * n, i * n);
    largest = std::max(largest, compliance[i]);
  }
  for (double &value : compliance)
    value = value > 1e-20 * largest ? value : 0.;
  Matrix W_normal(n_contacts, n_contacts);
  W_normal.setFromTriplets(entries.begin(), entries.end());
  FrictionlessNewton(W_normal, normal, compliance, settings).solve(P, report);
  for (unsigned int i = 0; i < n_contacts; ++i)
    result[i * n] = P[i];
  return result;
}

/**
 * In space: from the solution without friction, which is always found, to the full friction coefficients, as
 * fast as Newton follows. Where rigid modes dominate, Newton from a few sweeps has no chance: its first
 * active set is far from balance.
 */
double friction_continuation(const Matrix &W,
                             const Problem &problem,
                             const std::vector<double> &compliance,
                             const SolverSettings &settings,
                             std::vector<double> &impulses,
                             SolverReport &report)
{
  SolverReport own; // its iterations are counted apart, so that the attempt before has not used up the limit
  SolverSettings brief = settings;
  brief.max_newton_iterations = 25; // a step in friction that needs more is too long
  impulses = without_friction(W, problem, settings, own);
  Problem eased = problem;
  double reached = 0., step = 0.25, residual = 0.;
  while (reached < 1. && step > 1e-3 && own.newton_iterations < settings.max_newton_iterations)
  {
    const double target = std::min(1., reached + step);
    for (unsigned int i = 0; i < eased.friction.size(); ++i)
      eased.friction[i] = target * problem.friction[i];
    std::vector<double> trial = impulses;
    SolverReport attempt;
    residual = frictional_newton<3>(W, eased, compliance, brief, false, trial, attempt);
    own.newton_iterations += attempt.newton_iterations;
    own.regularised += attempt.regularised;
    // on the way a rough solution is enough
    if (residual <= (target < 1. ? std::max(1e-4, settings.tolerance) : settings.tolerance))
    {
      impulses.swap(trial);
      reached = target;
      step *= 2.;
    }
    else
      step *= 0.25;
  }
  report.newton_iterations += own.newton_iterations;
  report.regularised += own.regularised;
  return natural_residual(problem, compliance, impulses, velocities(W, problem, impulses));
}
} // namespace

const std::map<std::string, Algorithm> &algorithms()
{
  static const std::map<std::string, Algorithm> by_name = {{"gauss_seidel", Algorithm::gauss_seidel},
                                                           {"accelerated", Algorithm::accelerated},
                                                           {"active_set", Algorithm::active_set},
                                                           {"automatic", Algorithm::automatic}};
  return by_name;
}

double newton_active_set(const Eigen::SparseMatrix<double, Eigen::RowMajor> &W,
                         const Problem &problem,
                         const std::vector<double> &compliance,
                         const SolverSettings &settings,
                         std::vector<double> &impulses,
                         SolverReport &report)
{
  if (problem.n_components == 1)
    return FrictionlessNewton(W, problem, compliance, settings).solve(impulses, report);
  const auto newton = problem.n_components == 2 ? frictional_newton<2> : frictional_newton<3>;
  return newton(W, problem, compliance, settings, true, impulses, report);
}

/// Sweeps between two rounds of Newton, doubled when a round did not help, after which Algorithm::active_set
/// gives up: where Newton fails so often, more sweeps do not help.
constexpr unsigned int most_between_rounds = 200;

/// Iterations in each of the first rounds, without friction and with it, and the round from which all that
/// are allowed are made.
constexpr unsigned int brief_pivoting = 15, brief_newton = 6, patient_rounds = 2;

namespace
{
/// Newton's method in rounds, with sweeps between them.
template <class Operator>
class NewtonRounds
{
public:
  /// @param impulses,velocities,report what sweeps have come to; go on from there
  /// @param warm the impulses at the start were those of a problem like this one
  NewtonRounds(Operator &op,
               const Problem &problem,
               const SolverSettings &settings,
               const bool warm,
               std::vector<double> &impulses,
               std::vector<double> &velocities,
               SolverReport &report)
      : op(op)
      , problem(problem)
      , settings(settings)
      , warm(warm)
      , W(op.assemble())
      , compliance(contact_compliance(op))
      , speed(approach_speed(problem, compliance))
      , impulses(impulses)
      , velocities(velocities)
      , report(report)
      , best(impulses)
      , lowest(report.residual)
  {
  }

  void go();

private:
  void evaluate();
  /// Keeps the best impulses.
  void remember();
  /// Impulses of one round of Newton. @return their residual
  double newton(std::vector<double> &trial, SolverReport &own);
  /// One round. @return whether it was the last
  bool round();
  void sweep();

  Operator &op;
  const Problem &problem;
  const SolverSettings &settings;
  const bool warm;
  const Matrix W;
  const std::vector<double> compliance;
  const double speed;
  std::vector<double> &impulses, &velocities;
  SolverReport &report;
  std::vector<double> best;
  double lowest;
  unsigned int chunk = 50, rounds = 0; ///< sweeps after a round
  bool started_again = false;
};

template <class Operator>
void NewtonRounds<Operator>::evaluate()
{
  compute_velocities(op, problem, impulses, velocities);
  report.residual = natural_residual(problem, compliance, impulses, velocities);
  report.converged = report.residual <= settings.tolerance;
  report.limited_by_rounding = !report.converged && report.residual <= rounding_floor(W, impulses, speed);
  report.prescribed_approach = prescribed_approach(problem, compliance, velocities);
}

template <class Operator>
void NewtonRounds<Operator>::remember()
{
  if (report.residual < lowest)
  {
    lowest = report.residual;
    best = impulses;
  }
}

template <class Operator>
double NewtonRounds<Operator>::newton(std::vector<double> &trial, SolverReport &own)
{
  SolverSettings attempt = settings;
  // Newton ends soon or wanders: a few sweeps are then a better start than many more exchanges. In space
  // each friction coefficient on the way has its own limit.
  if (problem.n_components <= 2 && rounds < patient_rounds)
    attempt.max_newton_iterations =
        std::min(settings.max_newton_iterations, problem.n_components == 1 ? brief_pivoting : brief_newton);
  double after = newton_active_set(W, problem, compliance, attempt, trial, own);
  const bool plane = problem.n_components == 2;
  // In the plane at once: sweeps would lead away from impulses that may be close.
  if (after > settings.tolerance && problem.n_components > 1 && !started_again &&
      (plane || rounds > 0 || !warm))
  {
    started_again = true; // a second time would end the same
    std::vector<double> other = impulses;
    const auto method = plane ? follow_path : friction_continuation;
    const double residual = method(W, problem, compliance, settings, other, own);
    if (residual < after)
    {
      after = residual;
      trial.swap(other);
    }
  }
  return after;
}

template <class Operator>
void NewtonRounds<Operator>::sweep()
{
  SolverSettings sweeping = settings;
  sweeping.max_sweeps = std::min(chunk, settings.max_sweeps - report.sweeps);
  const SolverReport more = gauss_seidel(op, problem, sweeping, impulses, velocities);
  report.sweeps += more.sweeps;
  report.fell_back = report.fell_back || more.fell_back;
  evaluate();
  remember();
}

template <class Operator>
bool NewtonRounds<Operator>::round()
{
  SolverReport own; // a budget of iterations for each round; chunk limits the number of rounds
  const double before = report.residual, lowest_before = lowest;
  std::vector<double> trial = impulses;
  const double after = newton(trial, own);
  report.newton_iterations += own.newton_iterations;
  report.regularised += own.regularised;
  if (after < before)
  {
    report.accelerated = true;
    impulses.swap(trial);
    evaluate();
    remember();
  }
  report.came_back = own.came_back;
  const bool again = own.came_back && rounds > 0 && after <= 1.001 * lowest_before;
  if (report.converged || report.limited_by_rounding || report.sweeps >= settings.max_sweeps ||
      (settings.algorithm == Algorithm::active_set && (chunk > most_between_rounds || again)))
    return true;
  // Sweeps may lead away from an iterate that Newton then finds again: progress is a better best residual.
  if (!(lowest < 0.1 * lowest_before) && rounds > 0)
    chunk *= 2;
  ++rounds;
  sweep(); // polishing, or a better start for the next round
  return report.converged || report.limited_by_rounding;
}

template <class Operator>
void NewtonRounds<Operator>::go()
{
  while (!round())
    ;
  if (lowest < report.residual) // sweeps can leave a good iterate of an ill-conditioned problem
  {
    impulses = best;
    evaluate();
  }
}
} // namespace

template <class Operator>
SolverReport solve(Operator &op,
                   const Problem &problem,
                   const SolverSettings &settings,
                   std::vector<double> &impulses,
                   std::vector<double> &velocities)
{
  if (!problem.cohesion.empty())
    return solve_with_shifted_cones(
        op, problem, impulses, velocities,
        [&](const Problem &shifted, std::vector<double> &P, std::vector<double> &w)
        { return solve(op, shifted, settings, P, w); });
  // Sweeps cost little and find most of the active set.
  SolverSettings sweeping = settings;
  const bool newton_allowed = settings.algorithm == Algorithm::active_set ||
                              (settings.algorithm == Algorithm::automatic &&
                               problem.free_velocity.size() <= settings.max_newton_components);
  // Impulses to start from name the active set, and Newton needs no more.
  const bool warm = settings.algorithm == Algorithm::active_set &&
                    std::any_of(impulses.begin(), impulses.end(), [](const double P) { return P > 0.; });
  if (settings.algorithm == Algorithm::active_set)
    sweeping.max_sweeps = warm ? 0 : std::min(settings.max_sweeps, 10u);
  else if (newton_allowed)
    sweeping.max_sweeps = std::min(settings.max_sweeps, settings.sweeps_before_newton);
  SolverReport report = gauss_seidel(op, problem, sweeping, impulses, velocities);
  if (!report.converged && newton_allowed)
    NewtonRounds<Operator>(op, problem, settings, warm, impulses, velocities, report).go();
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
