// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_model_h
#define softgrain_model_model_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/model/model_facts.h>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;
class WallDrive;

/// What one accepted step took; rejected attempts are counted in it.
struct StepReport
{
  double dt = 0;             ///< of the accepted step [s]
  unsigned int attempts = 1; ///< 1 + number of times the step was cut
  unsigned int newton_iterations = 0;
  unsigned int contact_sweeps = 0;
  double newton_residual = 0;  ///< relative
  double contact_residual = 0; ///< relative, of the solution (natural map)
  double max_penetration = 0;  ///< [m]
  unsigned int n_contacts = 0; ///< rows that carry force
};

/**
 * @brief A way to compute a scene: what the driver and the command line see of it that is the same in the
 * plane and in space. Units are those of space; in the plane all is per metre of thickness.
 */
class AnyModel : public ModelFacts
{
public:
  /// "mpm" or "bpm".
  virtual std::string name() const = 0;

  /**
   * @brief Advances by one step of at most @p dt_limit (the way to the next output or to the end) [s].
   * @throw ComputationError when no acceptable step is found; the state is then that before the call.
   * @throw Interrupted when the program is to stop (base/interruption.h); the state is that before the call
   * too.
   */
  virtual StepReport advance(double dt_limit) = 0;

  /**
   * @brief Makes the state after a step what may be written, and adds what that took to @p report.
   *
   * Time stands still. Called after the steps that are written, not after all: `quasi_static` looks for
   * balance here. Nothing is to be done in most models.
   * @throw ComputationError when it cannot be done, Interrupted when the program is to stop; the state is
   * then that before the step, that is before the last advance()
   */
  virtual void settle(StepReport &report) { (void) report; }

  /**
   * @brief Forgets a step that was given up, before the state is drawn for the last time: what the attempt
   * has left of contacts is not that of the state.
   *
   * Where a model cannot tell what contacts carried before, it shows none. No step follows.
   */
  virtual void forget_attempt() {}

  /**
   * @brief Shares the work out anew among processes when it has become uneven; all call it between steps.
   * @return what the log is to say of it; empty when all stays as it is
   */
  virtual std::string share_out_anew() { return {}; }

  /// Output times and ends of stages are met exactly. Once fewer than this number of natural steps are left,
  /// the time left is divided into equal steps. With 2 no sliver remains before such a time; a larger number
  /// keeps all steps near the natural length, for models whose stress depends on the length of a step.
  virtual unsigned int equal_steps() const { return 2; }

  /// Drives the walls as @p drives say from now on, one per wall; null: as before.
  virtual void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) = 0;

  /// Everything needed to go on as if never stopped. All processes call both; what counts is what the
  /// first one writes, and all read the same.
  virtual void save(StateWriter &) const = 0;
  virtual void load(StateReader &) = 0;
};

/**
 * @brief A model with what is seen of its state: what writers and measures work on.
 */
template <int dim>
class Model : public AnyModel
{
public:
  /// The neutral state: what pictures and measures are made of. Costs a pass over the points. All
  /// processes call it, and the first one is told of the points of all; what else it tells, all are told.
  virtual Snapshot<dim> snapshot() const = 0;

  /// The part of the neutral state that tells who touches whom: time, centres of bodies, walls, obstacles and
  /// contacts, without points and outlines. It is cheap enough for every step. All processes call it,
  /// and what the first one is told counts.
  virtual Snapshot<dim> touching_state() const { return snapshot(); }

  /// Walls alone, cheap enough for every step.
  virtual std::vector<WallState<dim>> walls() const = 0;
  /// Obstacles alone, as cheap.
  virtual std::vector<ObstacleState<dim>> obstacles() const { return {}; }
};
} // namespace softgrain

#endif
