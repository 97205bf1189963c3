// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_gauss_seidel_h
#define softgrain_contact_gauss_seidel_h

#include <softgrain/contact/problem.h>

#include <vector>

namespace softgrain::contact
{
/// Which way solve() takes (see active_set.h).
enum class Algorithm
{
  gauss_seidel, ///< plain sweeps only
  accelerated,  ///< sweeps with momentum only
  active_set,   ///< a few sweeps, then Newton on the active set
  automatic     ///< sweeps with momentum, and Newton when they get nowhere
};

/// What the solvers may be told.
struct SolverSettings
{
  /// Bound of natural_residual(): velocity errors relative to the approach speed.
  double tolerance = 1e-8;

  /// Sweeps over all contacts at most, those before and after Newton included.
  unsigned int max_sweeps = 10000;

  /// Factor of plain sweeps on the change of each impulse, in (0, 2); the result is projected back on the
  /// cone when it is not 1.
  double relaxation = 1.;

  /// The residual of the solution is computed every so many sweeps (it costs about one sweep).
  unsigned int check_interval = 5;

  /// gauss_seidel() only asks whether it is Algorithm::gauss_seidel.
  Algorithm algorithm = Algorithm::automatic;

  /// Sweeps that solve() makes with Algorithm::automatic before it takes Newton.
  unsigned int sweeps_before_newton = 100;

  /// Contact components above which Algorithm::automatic stays with sweeps: Newton factorises.
  unsigned int max_newton_components = 2000;

  /// Newton iterations at most in one call of solve().
  unsigned int max_newton_iterations = 100;

  /// @throw InputError when a value is out of range.
  void check() const;
};

/// What a solver did.
struct SolverReport
{
  unsigned int sweeps = 0;
  /// natural_residual() of the solution returned, recomputed from its impulses.
  double residual = 0.;
  bool converged = true;
  /// Not converged, but the residual is below what rounding leaves of W P (rigid modes far above the elastic
  /// part): no better solution can be found in double precision. Set by solve() only.
  bool limited_by_rounding = false;
  /// Momentum was given up and plain sweeps went on.
  bool fell_back = false;
  /// Newton's method has repeated its iterates: one contact neither sticks nor slides as the others are.
  bool came_back = false;
  /// Newton was used, and gave the solution that is returned or polished.
  bool accelerated = false;
  unsigned int newton_iterations = 0;
  /// Linear systems that Newton had to regularise further because they were singular.
  unsigned int regularised = 0;
  /// Contacts whose impulse cannot change anything (W_nn = 0) and the worst approach speed left there (m/s).
  unsigned int prescribed_contacts = 0;
  double prescribed_approach = 0.;
};

/**
 * @brief Nonlinear Gauss–Seidel (Moreau and Jean): contacts one after the other, each solved exactly with
 * solve_local(), until the residual of the solution is below the tolerance.
 *
 * Unless the algorithm is Algorithm::gauss_seidel, sweeps start ahead of the last impulses (see Momentum);
 * when that makes the residual grow or stand still they go on from the best impulses both ways, there and
 * back, and when that does too, without momentum.
 *
 * In the order of the contacts, or of Problem::colors and then on all threads: the result does not depend on
 * their number.
 * @tparam Operator DiagonalDelassus, BlockDelassus or MassDelassus
 * @param op the Delassus operator; holds the solution's state afterwards
 * @param problem q and mu
 * @param settings tolerance and limits
 * @param impulses warm start in (empty: zero), solution out; n_contacts * n_components (N s per metre)
 * @param velocities W P + q (m/s), out
 * @throw InputError when sizes do not fit. @throw ComputationError when something is not finite.
 * Not reaching the tolerance is not an error here: see SolverReport::converged.
 */
template <class Operator>
SolverReport gauss_seidel(Operator &op,
                          const Problem &problem,
                          const SolverSettings &settings,
                          std::vector<double> &impulses,
                          std::vector<double> &velocities);

/// Sets the operator to @p impulses and writes W P + q to @p velocities.
template <class Operator>
void compute_velocities(Operator &op,
                        const Problem &problem,
                        const std::vector<double> &impulses,
                        std::vector<double> &velocities);
} // namespace softgrain::contact

#endif
