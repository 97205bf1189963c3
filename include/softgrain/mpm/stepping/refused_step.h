// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_refused_step_h
#define softgrain_mpm_stepping_refused_step_h

#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/stepping/stress.h>

#include <string>
#include <vector>

namespace softgrain::contact
{
struct SolverReport;
}

namespace softgrain::mpm
{
struct StepOutcome;

/// A number with three digits, for messages.
std::string short_number(double value);

/// What @p iteration returns, or why linear and contact solvers gave it up: a shorter step may do.
template <class Iteration>
std::string or_why_it_failed(const Iteration &iteration)
{
  try
  {
    return iteration();
  }
  catch (const ComputationError &error)
  {
    return error.what();
  }
}

/// Why a step is no good whose contact problem was not solved.
std::string not_solved(const contact::SolverReport &report);

/// Why a step is no good in which the points of @p body came out as @p outcome tells.
template <int dim>
std::string why_not(const Body<dim> &body, const StressOutcome &outcome);

/// How the stress of every body came out, for all to know. Of refusals they learn the first, which is
/// the one that is told.
class SharedOutcomes
{
public:
  SharedOutcomes(const BodyShare &share, std::vector<StressOutcome> &stress) : share(share), stress(stress) {}
  /// Adds the outcomes of owned bodies, when they are there.
  void add_to(BodyShare::Message &message);
  /// Takes the outcomes of all, after the exchange.
  void take();

private:
  const BodyShare &share;
  std::vector<StressOutcome> &stress;
  std::vector<double> points, leaps, shares;
};

/// Takes back an accepted @p outcome when the law of a body asks for a shorter step.
template <int dim>
void heed_laws(const std::vector<Body<dim>> &bodies,
               const std::vector<StressOutcome> &stress,
               StepOutcome &outcome);
} // namespace softgrain::mpm

#endif
