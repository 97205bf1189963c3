// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_step_equations_h
#define softgrain_mpm_stepping_step_equations_h

#include <softgrain/mpm/stepping/body_equations.h>
#include <softgrain/mpm/stepping/body_terms.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/stress.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The equations of one implicit step for the velocities at its end, body by body: unbalanced impulse
 * for a trial, and the matrix of Newton's method. See doc/theory.md, "One step".
 *
 * Vectors hold one nodal vector per body; those of driven bodies are not used. End
 * velocities and what is unbalanced are those of owned bodies alone, and with rays so are increments.
 */
class StepEquations : public BodyEquations<2>
{
public:
  /// Takes forces and loads at the start of the step from @p state.
  StepEquations(const Problem &problem, const State &state, Workspace &work, const StepPlan &plan);

  /// Stress and unbalanced impulse for the end velocities @p v; false when a point turns inside out
  /// or deforms by too much over the step.
  bool evaluate(const Vectors &v) override;

  Eigen::VectorXd end_velocity(const Body<2> &body, const Eigen::VectorXd &way) const override
  {
    return scheme_terms[body.index]->end_velocity(body, way);
  }

  /// A way from end velocities @p x, for which increments were @p from.
  struct Way
  {
    const Vectors &x, &direction, &from;
  };
  /// Evaluates velocities @p fraction of the way along, which @p v becomes; bodies turn along circles.
  bool evaluate_on_way(const Way &way, double fraction, Vectors &v);
  /// Why the last evaluate() failed.
  std::string why_not() const override { return mpm::why_not(state.bodies[bad_body], trouble); }
  /// How the last evaluate() came out, body by body.
  const std::vector<StressOutcome> &stress_outcome() const { return stress; }

  /// Impulse that is missing for balance at every node of a body, those of the contacts counted [N s/m].
  Eigen::VectorXd unbalanced(unsigned int b) const;
  /// Norm of unbalanced() of all bodies as last evaluated, with the impulses of then [N s/m].
  double unbalanced_norm() const;
  /// The largest such norm of a body over the largest impulse of the step on a body.
  double residual() const;
  /// Whether what is unbalanced of every body is no more than the rounding of what is summed for it: no
  /// search finds less. Costs a pass over the points. All owners call it.
  bool at_rounding() const;
  /// What rounding may do to the unbalanced impulse of an owned body, as last evaluated [N s/m].
  /// @param contact norm of the impulses of contacts on its nodes
  double rounding(const Body<2> &body, double contact) const override;
  /// The body of which most is unbalanced, in words; for messages.
  std::string worst_body() const;
  /// Norm of the end velocities as last evaluated [m/s].
  double trial_length() const;
  /// Takes new contact rows into account.
  void rows_changed();

  /// A = M + theta^2 dt^2 K of every body, factorised; shifted when it is not positive definite.
  /// @return why not, empty when it went well
  std::string factorise();

  /// What the scheme does with an owned body.
  const BodyTerms<2> &terms(const unsigned int b) const { return *scheme_terms[b]; }

  /// Numbers that a step tells of a body.
  using Told = std::array<double, 5>;
  /// Adds forces and ways of the bodies at the end of the step, and @p told of each, to what owners tell each
  /// other.
  void tell(std::vector<Told> &told, BodyShare::Message &message);
  /// What a direction promises, of all bodies.
  struct Slope
  {
    double work = 0;   ///< of the right hand side along it
    double merit = 0;  ///< norm of the right hand side [N s/m]
    double length = 0; ///< norm of it [m/s]
  };
  /// A x = the missing impulse, or what is unbalanced with contact, for every owned body [m/s].
  Slope solve(bool with_contact, Vectors &x) const;

  /// A x = the missing impulse of a body that touches nothing [m/s].
  void solve_free(unsigned int b, Eigen::VectorXd &x) const override;

  /// Impulse that is missing for balance without contact, as last evaluated [N s/m].
  const Eigen::VectorXd &missing(const unsigned int b) const override { return missing_impulse[b]; }
  /// A of one body as its forces have it, nothing held stable.
  void assemble_exact(const Body<2> &body) override;
  void resist_more(double factor, const Vectors &v, bool in_matrices) override;

  /// When external was taken.
  const LoadTimes &load_times() const { return loads; }

  /// H v at the start of the step, empty when theta is 1 [m/s].
  std::vector<double> start_relative;

private:
  /// evaluate(), in which a body's end velocities become known by @p before.
  bool evaluate_after(const std::function<void(unsigned int)> &before, const Vectors &v);
  /// Finds the missing impulse from the internal forces.
  void find_missing_impulse(const Body<2> &body, const Eigen::VectorXd &v);
  void measure(const Body<2> &body, const Eigen::VectorXd &v);
  Eigen::VectorXd go(unsigned int b, const Way &way, double fraction) const;

  const Problem &problem;
  const State &state;
  Workspace &work;
  const TimeScheme &scheme;
  const StepPlan plan;
  const double dt;
  LoadTimes loads;
  Vectors fixed_external;                                  ///< of external, what does not depend on the trial
  std::vector<std::unique_ptr<BodyTerms<2>>> scheme_terms; ///< of every moving body that is owned
  Vectors missing_impulse;
  /// Four numbers of every body as last evaluated: square and norm of what is unbalanced, its largest
  /// impulse, square of the end velocities.
  std::vector<std::array<double, 4>> measured;
  bool rows_known = false; ///< contact has the rows of this step
  unsigned int bad_body = 0;
  std::vector<StressOutcome> stress;
  StressOutcome trouble;
};
} // namespace softgrain::mpm

#endif
