// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/parallel.h>
#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/diagonal_delassus.h>
#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/contact/local_solver.h>
#include <softgrain/contact/mass_delassus.h>
#include <softgrain/contact/momentum.h>
#include <softgrain/contact/residual.h>
#include <softgrain/contact/shifted_cones.h>
#include <softgrain/contact/thread_team.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

namespace softgrain::contact
{
namespace
{
/// Calls @p work on pieces of [0, n_items), the same ones for any number of threads, on those of @p team if
/// there is one.
template <class Work>
void in_pieces(ThreadTeam *team, const std::size_t n_items, const std::size_t piece, const Work &work)
{
  const auto run = [&](const std::uint32_t i) { work(i * piece, std::min(n_items, (i + 1) * piece)); };
  const std::size_t n_pieces = (n_items + piece - 1) / piece;
  if (team != nullptr)
    return team->run(n_pieces, run);
  for (std::size_t i = 0; i < n_pieces; ++i)
    run(i);
}

template <unsigned int n, class Operator>
void velocities_of_all(Operator &op,
                       const Problem &problem,
                       std::vector<double> &velocities,
                       ThreadTeam *team = nullptr)
{
  in_pieces(team, problem.n_contacts(), 64,
            [&](const std::size_t begin, const std::size_t end)
            {
              double w[n];
              for (std::size_t i = begin; i < end; ++i)
              {
                op.template velocity<n>(i, w);
                for (unsigned int c = 0; c < n; ++c)
                  velocities[i * n + c] = w[c] + problem.free_velocity[i * n + c];
              }
            });
}

/// What a sweep works on.
template <class Operator>
struct Sweep
{
  Operator &op;
  const Problem &problem;
  const std::vector<double> &blocks, &compliance;
  double relaxation;
  std::vector<double> &impulses;
  bool backwards; ///< from the last contact to the first
};

/// Solves one contact after the other; returns the largest change of an impulse times the contact's
/// compliance (m/s).
template <unsigned int n, class Operator>
double solve_range(const Sweep<Operator> &on, const unsigned int first, const unsigned int end)
{
  double largest = 0.;
  for (unsigned int k = first; k < end; ++k)
  {
    const unsigned int i = on.backwards ? first + (end - 1 - k) : k;
    if (!(on.compliance[i] > 0.))
      continue;
    double *P = &on.impulses[i * n];
    const double *W = &on.blocks[i * n * n], *q = &on.problem.free_velocity[i * n];
    double w[n], next[n], change[n];
    on.op.template velocity<n>(i, w);
    for (unsigned int c = 0; c < n; ++c)
      w[c] += q[c];
    if (P[0] == 0. && w[0] >= 0.)
      continue; // open and stays open: most rows of a soft-body scene
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int d = 0; d < n; ++d)
        w[c] -= W[c * n + d] * P[d];
    const double mu = on.problem.friction_of(i);
    solve_local<n>(W, w, mu, next);
    if (on.relaxation != 1.)
    {
      for (unsigned int c = 0; c < n; ++c)
        next[c] = P[c] + on.relaxation * (next[c] - P[c]);
      project_on_cone<n>(mu, next);
    }
    double size = 0.;
    for (unsigned int c = 0; c < n; ++c)
    {
      change[c] = next[c] - P[c];
      P[c] = next[c];
      size = std::max(size, std::abs(change[c]));
    }
    if (size == 0.)
      continue;
    on.op.template apply<n>(i, change);
    largest = std::max(largest, size * on.compliance[i]);
  }
  return largest;
}

/// One sweep over all contacts, colour by colour; returns what solve_range() does.
/// @param of_piece scratch
template <unsigned int n, class Operator>
double sweep(const Sweep<Operator> &on, ThreadTeam *team, std::vector<double> &of_piece)
{
  if (on.problem.colors.empty())
    return solve_range<n>(on, 0, on.problem.n_contacts());
  constexpr std::size_t piece = 8; // ranges to an item: some microseconds of work
  double largest = 0.;
  const std::size_t n_colors = on.problem.colors.size();
  for (std::size_t k = 0; k < n_colors; ++k)
  {
    const std::vector<Problem::Range> &color = on.problem.colors[on.backwards ? n_colors - 1 - k : k];
    of_piece.assign((color.size() + piece - 1) / piece, 0.);
    in_pieces(team, color.size(), piece,
              [&](const std::size_t begin, const std::size_t end)
              {
                double &mine = of_piece[begin / piece];
                for (std::size_t r = begin; r < end; ++r) // of one colour: their order does not matter
                  mine = std::max(mine, solve_range<n>(on, color[r].first, color[r].end));
              });
    for (const double mine : of_piece)
      largest = std::max(largest, mine);
  }
  return largest;
}

/// Sweeps without a lower residual after which momentum goes on with forward and backward sweeps, or, when it
/// does so already, is given up.
constexpr unsigned int patience_one_way = 50, patience_both_ways = 200;

/**
 * One call of gauss_seidel().
 *
 * A forward and a backward sweep are together a gradient step in the metric (D + L) D^-1 (D + L^T) with W = L
 * + D + L^T, and momentum is a method for gradient steps. Forward sweeps alone converge as well on most
 * problems, for half the cost or less (memory is read forwards). On some problems they circle without end, so
 * the residual is watched.
 */
template <unsigned int n, class Operator>
class Iteration
{
public:
  Iteration(Operator &op,
            const Problem &problem,
            const SolverSettings &settings,
            std::vector<double> &impulses,
            std::vector<double> &velocities)
      : op(op)
      , problem(problem)
      , settings(settings)
      , impulses(impulses)
      , velocities(velocities)
      , blocks(std::size_t(problem.n_contacts()) * n * n)
      , momentum(n)
      , accelerating(settings.algorithm != Algorithm::gauss_seidel)
  {
    op.begin(impulses);
    for (unsigned int i = 0; i < problem.n_contacts(); ++i)
      op.diagonal_block(i, &blocks[i * n * n]);
    compliance = contact_compliance(op);
    speed = approach_speed(problem, compliance);
    for (unsigned int i = 0; i < problem.n_contacts(); ++i)
      if (!(compliance[i] > 0.))
      {
        ++report.prescribed_contacts;
        std::fill_n(&impulses[i * n], n, 0.);
      }
    best = impulses;
    // Threads that spin pay only where a colour is some microseconds of work.
    if (speed > 0. && !problem.colors.empty() && problem.n_contacts() >= 512 && n_threads() > 1)
      team = std::make_unique<ThreadTeam>(n_threads());
  }

  SolverReport run()
  {
    if (speed == 0.) // nothing approaches: P = 0 solves the problem exactly
      std::fill(impulses.begin(), impulses.end(), 0.);
    bool checked = false;
    report.converged = false;
    unsigned int next_check = settings.check_interval;
    while (speed > 0. && report.sweeps < settings.max_sweeps && !report.converged)
    {
      stop_if_interrupted();
      const double change = accelerating ? sweep_from_ahead() : one_sweep(settings.relaxation, false);
      checked = report.sweeps >= next_check || !(change > settings.tolerance * speed);
      if (checked)
      {
        check();
        next_check = report.sweeps + settings.check_interval;
      }
    }
    if (!checked)
      evaluate();
    if (accelerating && !report.converged && !(report.residual <= momentum.lowest_residual()))
    {
      accelerating = false;
      return_to_best();
    }
    report.prescribed_approach = prescribed_approach(problem, compliance, velocities);
    return report;
  }

private:
  /// Returns the largest change of an impulse, as a velocity.
  double one_sweep(const double relaxation, const bool backwards)
  {
    ++report.sweeps;
    return sweep<n>(Sweep<Operator>{op, problem, blocks, compliance, relaxation, impulses, backwards},
                    team.get(), of_piece);
  }

  /// A sweep from ahead of the last impulses, or, both ways, a sweep and the same backwards; returns the
  /// largest change of the last one.
  double sweep_from_ahead()
  {
    start_ahead(momentum.next());
    double change = one_sweep(1., false);
    if (both_ways && report.sweeps < settings.max_sweeps)
      change = one_sweep(1., true);
    if (n == 1 && uphill()) // without friction the sweeps descend a convex function
      momentum.restart();
    return change;
  }

  /// Whether the last step went against the momentum, Σ W_ii (start - P) (P - before) > 0.
  bool uphill() const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < impulses.size(); ++k)
      sum += compliance[k / n] * (start[k] - impulses[k]) * (impulses[k] - before[k]);
    return sum > 0.;
  }

  /// Impulses P to P + factor (P - before), on the cone; a contact that is open stays so.
  void start_ahead(const double factor)
  {
    if (factor == 0.)
    {
      before = start = impulses;
      return;
    }
    for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    {
      double *P = &impulses[i * n], *old = &before[i * n], ahead[n];
      for (unsigned int c = 0; c < n; ++c)
        ahead[c] = P[0] > 0. ? P[c] + factor * (P[c] - old[c]) : 0.;
      project_on_cone<n>(problem.friction_of(i), ahead);
      for (unsigned int c = 0; c < n; ++c)
      {
        old[c] = P[c];
        P[c] = start[i * n + c] = ahead[c];
      }
    }
    op.begin(impulses);
  }

  void evaluate()
  {
    // Afresh from the impulses: an operator that updates its state collects rounding over many sweeps.
    op.begin(impulses);
    velocities_of_all<n>(op, problem, velocities, team.get());
    report.residual = natural_residual(problem, compliance, impulses, velocities);
    if (std::isnan(report.residual) && !accelerating)
      throw ComputationError("contact solver: an impulse is no longer finite after " +
                             std::to_string(report.sweeps) + " sweeps");
    report.converged = report.residual <= settings.tolerance;
  }

  /// Evaluates, and watches what momentum does.
  void check()
  {
    evaluate();
    if (!accelerating || report.converged)
      return;
    if (report.residual < momentum.lowest_residual())
    {
      sweeps_at_lowest = report.sweeps;
      best = impulses;
    }
    if (momentum.judge(report.residual) == Momentum::Verdict::give_up ||
        report.sweeps - sweeps_at_lowest >= (both_ways ? patience_both_ways : patience_one_way))
    {
      // One step down the ladder: one way, both ways, plain.
      accelerating = !both_ways;
      report.fell_back = both_ways;
      both_ways = true;
      momentum.return_to_lowest();
      return_to_best();
      sweeps_at_lowest = report.sweeps;
    }
  }

  void return_to_best()
  {
    impulses = best;
    evaluate();
  }

  Operator &op;
  const Problem &problem;
  const SolverSettings &settings;
  std::vector<double> &impulses, &velocities;
  std::vector<double> blocks, compliance;
  std::vector<double> before, start, best; ///< impulses: a step ago, sweeps went from, lowest residual
  std::vector<double> of_piece;            ///< scratch of a sweep
  std::unique_ptr<ThreadTeam> team;
  Momentum momentum;
  SolverReport report;
  bool accelerating, both_ways = false;
  double speed = 0.;
  unsigned int sweeps_at_lowest = 0;
};
} // namespace

template <class Operator>
void compute_velocities(Operator &op,
                        const Problem &problem,
                        const std::vector<double> &impulses,
                        std::vector<double> &velocities)
{
  velocities.resize(problem.free_velocity.size());
  op.begin(impulses);
  if (problem.n_components == 1)
    velocities_of_all<1>(op, problem, velocities);
  else if (problem.n_components == 2)
    velocities_of_all<2>(op, problem, velocities);
  else
    velocities_of_all<3>(op, problem, velocities);
}

template <class Operator>
SolverReport gauss_seidel(Operator &op,
                          const Problem &problem,
                          const SolverSettings &settings,
                          std::vector<double> &impulses,
                          std::vector<double> &velocities)
{
  if (!problem.cohesion.empty())
    return solve_with_shifted_cones(
        op, problem, impulses, velocities,
        [&](const Problem &shifted, std::vector<double> &P, std::vector<double> &w)
        { return gauss_seidel(op, shifted, settings, P, w); });
  settings.check();
  problem.check();
  if (op.n_components() != problem.n_components || op.n_contacts() != problem.n_contacts())
    throw InputError("contact solver: the operator has " + std::to_string(op.n_contacts()) + " contacts of " +
                     std::to_string(op.n_components()) + " components, the problem " +
                     std::to_string(problem.n_contacts()) + " of " + std::to_string(problem.n_components));
  if (impulses.empty())
    impulses.assign(problem.free_velocity.size(), 0.);
  if (impulses.size() != problem.free_velocity.size())
    throw InputError("contact solver: " + std::to_string(impulses.size()) + " impulses to start from, " +
                     std::to_string(problem.free_velocity.size()) + " expected");
  for (std::size_t i = 0; i < impulses.size(); ++i)
    if (!std::isfinite(impulses[i]))
      throw ComputationError("contact " + std::to_string(i / problem.n_components) +
                             ": the impulse to start from is not finite");
  velocities.resize(impulses.size());
  if (problem.n_components == 1)
    return Iteration<1, Operator>(op, problem, settings, impulses, velocities).run();
  if (problem.n_components == 2)
    return Iteration<2, Operator>(op, problem, settings, impulses, velocities).run();
  return Iteration<3, Operator>(op, problem, settings, impulses, velocities).run();
}

#define SOFTGRAIN_INSTANTIATE(Operator)                                                                      \
  template SolverReport gauss_seidel(Operator &, const Problem &, const SolverSettings &,                    \
                                     std::vector<double> &, std::vector<double> &);                          \
  template void compute_velocities(Operator &, const Problem &, const std::vector<double> &,                 \
                                   std::vector<double> &);
SOFTGRAIN_INSTANTIATE(DiagonalDelassus)
SOFTGRAIN_INSTANTIATE(BlockDelassus)
SOFTGRAIN_INSTANTIATE(MassDelassus)
#undef SOFTGRAIN_INSTANTIATE
} // namespace softgrain::contact
