// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_space_equations_h
#define softgrain_mpm_stepping_space_equations_h

#include <softgrain/linear/low_rank_solver.h>
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/body/step_state.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/mpm/stepping/body_equations.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/mpm/stepping/nodal_resistance.h>
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/stress.h>

#include <deal.II/base/timer.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/// What steps in space work with and every step fills anew.
struct SpaceWorkspace
{
  BodyShare share;
  std::vector<StepState<3>> trial;                     ///< one per body, of owned ones
  std::vector<SystemMatrix> matrices;                  ///< likewise
  std::vector<std::unique_ptr<LowRankSolver>> solvers; ///< likewise; null for others
  dealii::TimerOutput *timer = nullptr;

  /// Lays out room for owned bodies. @param equations whether steps solve some, with matrices and solvers
  void reinit(const std::vector<Body<3>> &bodies, const LinearSolverSettings &settings, bool equations);
};

/**
 * @brief The equations of a step at rest in space.
 *
 * Bodies resist as in the plane: each with a stiffness of 'Quasi-static/Regularisation' times that of its
 * material against motion. A round body without friction is the same when it is turned, but its grid is not,
 * and would turn it on and on: a stiff torque holds it, which is a choice of one of many equal answers.
 * Friction turns bodies, and they turn freely.
 */
class SpaceEquations : public BodyEquations<3>
{
public:
  /// @param time at the start of the step [s]
  SpaceEquations(const std::vector<Body<3>> &bodies,
                 const Settings &settings,
                 SpaceWorkspace &work,
                 const StepPlan &plan,
                 double time,
                 bool frictionless);

  bool evaluate(const Vectors &v) override;
  std::string why_not() const override;
  Eigen::VectorXd end_velocity(const Body<3> &, const Eigen::VectorXd &way) const override
  {
    return way / plan.dt;
  }
  const Eigen::VectorXd &missing(const unsigned int b) const override { return missing_impulse[b]; }
  double rounding(const Body<3> &body, double contact) const override;
  void assemble_exact(const Body<3> &body) override;
  void resist_more(double factor, const Vectors &v, bool in_matrices) override;
  void solve_free(unsigned int b, Eigen::VectorXd &x) const override;

  /// What holds back a body, as State::held_back [N].
  double held_back(unsigned int b) const;
  /// Work that what resists takes from a body in the step as last evaluated [J].
  double regularisation_work(unsigned int b) const;
  /// How the stress of all bodies came out when it was last evaluated.
  const std::vector<StressOutcome> &stress_outcome() const { return stress; }
  /// When external was taken.
  const LoadTimes &load_times() const { return loads; }

protected:
  /// Displacement over the step for the end velocity @p v [m].
  virtual Eigen::VectorXd increment_of(const Body<3> &body, const Eigen::VectorXd &v) const;
  /// Finds the missing impulse from the internal forces.
  virtual void find_missing(const Body<3> &body, const Eigen::VectorXd &v);

  const std::vector<Body<3>> &bodies;
  const Settings &settings;
  SpaceWorkspace &work;
  const StepPlan plan;
  const LoadTimes loads;
  Vectors missing_impulse;

private:
  std::vector<NodalResistance<3>> resistance; ///< [N s^2/m]
  std::vector<Eigen::MatrixXd> rotations;     ///< at the start of the step
  std::vector<double> rotation_weight;
  const double end; ///< of the step, as laws see time [s]
  std::vector<StressOutcome> stress;
  unsigned int bad_body = 0;
};
} // namespace softgrain::mpm

#endif
