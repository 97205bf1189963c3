// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_newton_search_h
#define softgrain_mpm_stepping_newton_search_h

#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/step_equations.h>

#include <string>

namespace softgrain::mpm
{
/// How far Newton's method goes along its directions, and when it has arrived. See doc/theory.md, "One step".
class NewtonSearch
{
public:
  using Vectors = StepEquations::Vectors;

  NewtonSearch(const Problem &problem, const State &state, const Workspace &work, StepEquations &equations);

  /// Goes from @p trial along @p direction, which promises @p slope, as far as the unbalanced impulse falls
  /// and no point turns inside out [m/s]. @return why there is no such way, empty when it went well
  std::string go(Vectors &trial, const Vectors &direction, const StepEquations::Slope &slope, bool first);

  /// Whether the step is found with the end velocities last evaluated: in balance, and the last direction
  /// short (@cite nguyen2016, eq. (3.22)).
  bool converged() const;

  /// Whether the factors of the last direction are good enough for the next one.
  bool factors_serve = false;

private:
  /// Goes back to where the search began when no way along @p direction leaves less. @return why the search
  /// ends there, empty when what is left is rounding
  std::string end_of_search(Vectors &trial, const Vectors &direction, double least);

  const Problem &problem;
  const State &state;
  const Workspace &work;
  StepEquations &equations;
  /// Velocities of owned bodies where the last search began; kept, for fresh memory is dear.
  Vectors x, from;
  double first_length = 0., first_work = 0., last_length = 0., last_work = 0.;
  bool stands_still = false; ///< the last direction left nearly as much as there was
};
} // namespace softgrain::mpm

#endif
