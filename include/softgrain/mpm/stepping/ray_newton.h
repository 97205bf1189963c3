// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ray_newton_h
#define softgrain_mpm_stepping_ray_newton_h

#include <softgrain/mpm/stepping/ray_equations.h>

#include <optional>
#include <string>

namespace softgrain::mpm
{
/**
 * @brief Newton's method for a step whose contacts are met by rays, in the plane and in space.
 *
 * Without inertia the step ends in a minimum of the energy of the bodies and of what resists their motion:
 * where the signs of the factors tell that there is none near, bodies resist more. See
 * doc/results/contact-geometry.md.
 */
template <int dim>
class RayNewton : protected RayEquations<dim>
{
  using Base = RayEquations<dim>;

public:
  using Base::RayEquations;
  using typename Base::Vectors;

  StepOutcome outcome;

protected:
  using Base::assemble;
  using Base::at_rest;
  using Base::at_rounding;
  using Base::candidates_within;
  using Base::deepest;
  using Base::deepest_by_force;
  using Base::equations;
  using Base::evaluate;
  using Base::factorise;
  using Base::force;
  using Base::frames;
  using Base::free_way;
  using Base::h;
  using Base::inertia;
  using Base::largest_way;
  using Base::lay;
  using Base::leave_unmet_rays;
  using Base::measure;
  using Base::meet;
  using Base::none;
  using Base::not_met;
  using Base::path;
  using Base::plan;
  using Base::residual;
  using Base::rubbing;
  using Base::scene;
  using Base::softest_pair;
  using Base::system;
  using Base::take_forces_of_start;
  using Base::theta;
  using Base::trial;
  using Base::way;
  using Base::why_not;
  using Base::world;

  /// Finds ways and forces. @return why there are none
  std::string converge();

private:
  /// Matrices of Newton's method and their factors, of all bodies.
  struct Matrices
  {
    bool assembled = false;               ///< for the ways and forces at hand
    std::optional<unsigned int> negative; ///< pivots; none where factors could not be found
    bool serve = false;                   ///< the factors are good enough for another iteration
  };
  /// Where an iteration sets out from.
  struct Start
  {
    RayForces force;
    RayFriction<dim> rubbing;
    Vectors way;
    std::vector<double> walls; ///< ways of those under loads [m]
  };
  /// The largest ways of an iteration [m]. Nodes on the rim of a body may go far and move nothing.
  struct Farthest
  {
    double place = 0.; ///< of a place under a ray that presses, or of a wall under a load
    double node = 0.;  ///< of a node of a body that meets something: no place goes further
  };

  bool converged() const;
  /// Whether a held step that is only on the way to balance may end.
  bool good_enough() const;
  bool begin();
  void begin_to_pull();
  std::string iterate();
  void find_factors();
  bool solve_contact();
  std::string find_forces();
  std::string find_direction(Vectors &direction);
  void follow_forces(Vectors &direction);
  bool goes_too_far(const Vectors &direction) const;
  Farthest farthest(const Vectors &direction) const;
  std::string go_along(const Vectors &direction);
  void go(const Start &from, const Vectors &direction, double share);
  bool resist_more();
  bool presses_more_than_resists() const;
  bool go_back();
  bool keep_dents();

  Matrices matrices;
  bool dents_kept = false;            ///< for the rest of the step, see keep_dents()
  unsigned int strained_in_a_row = 0; ///< the last iterations that were halved as they deform bodies too much
};

/// Finds a step, and hands it to a state if one is found. @tparam Step a RayNewton with find() and accept()
template <class Step, class StepsState>
StepOutcome try_ray_step(Step &step, StepsState &state)
{
  step.outcome.reason = step.find();
  step.outcome.accepted = step.outcome.reason.empty();
  if (step.outcome.accepted)
    step.accept(state);
  return step.outcome;
}
} // namespace softgrain::mpm

#endif
