// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_pressed_body_h
#define softgrain_mpm_stepping_pressed_body_h

#include <softgrain/linear/low_rank_solver.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>
#include <softgrain/mpm/contact/hertz_dent.h>
#include <softgrain/mpm/contact/one_sided_forces.h>
#include <softgrain/mpm/model/settings.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief One elastic body at rest between flat rigid walls without friction.
 *
 * A wall meets places of the material on the surface of the body, the same ones for ever. Gaps are linear in
 * the displacements of the nodes, so that the force on the wall and that on the body are opposite to
 * rounding. Newton's method solves for displacements and forces together: with K the stiffness of the body, f
 * its internal force, G the gradients of the gaps and δ the dents that the grid misses,
 *
 *     (K + α M) Δu = f + Gᵀ P,    P >= 0,    g + G Δu + δ(sum of P of the wall) >= 0,    P g = 0.
 *
 * α holds what nothing else holds: it counts from iterate to iterate, so that the state that is found is in
 * balance without it. It is raised where a set of closed places belongs to no minimum of the energy. A
 * compressed body has unstable motions that its contacts hold; the factors of K count them.
 *
 * A round body without friction is the same when it is turned, but its places are not: they would turn it as
 * cogs do. So a stiff torque keeps it from turning, which counts as a load.
 */
template <int dim>
class PressedBody
{
public:
  using Vector = dealii::Tensor<1, dim>;

  /// A flat wall, and what the grid of the body does not show of its contact.
  struct FlatWall
  {
    dealii::Point<dim> point; ///< [m]
    Vector normal;            ///< unit, to the body
    HertzDent dent;
  };

  /// @param body   at rest, with its grid; it is changed by balance() alone
  /// @param places on its surface, in the configuration of the grid, for every wall [m]
  PressedBody(Body<dim> &body,
              const std::vector<std::vector<dealii::Point<dim>>> &places,
              const Settings &settings,
              double cell_size);

  /// How a search for balance came out.
  struct Outcome
  {
    std::string trouble;         ///< empty: it is found
    unsigned int iterations = 0; ///< of Newton's method
    unsigned int passes = 0;     ///< of the sets of closed places
    double residual = 0;         ///< largest unbalanced force, over the largest
    double deepest = 0;          ///< by which a place that bears misses its wall, or another lies in it [m]
  };
  /// Finds balance between @p walls, from the present state on. When it does not, the state stays as it was.
  Outcome balance(const std::vector<FlatWall> &walls);

  /// Of all places, on the body along the normal of a wall [N in space].
  const std::vector<double> &forces(const std::size_t wall) const { return force[wall]; }
  double total_force(std::size_t wall) const;
  /// Where a place is [m].
  dealii::Point<dim> place(const std::size_t wall, const std::size_t k) const;
  /// That a wall may meet.
  std::size_t n_places(const std::size_t wall) const { return places[wall].size(); }
  /// Stress at the points, in balance.
  const StepState<dim> &points() const { return trial; }

  /// Takes a state from elsewhere. @return why it cannot be, or nothing
  std::string take(const Eigen::VectorXd &displacement, const std::vector<std::vector<double>> &forces);

private:
  using Forces = std::vector<std::vector<double>>;

  /// Mean rotations of the body where it is.
  void find_rotations();
  /// Stress, internal force and torque for a displacement. @return why not
  std::string evaluate(const Eigen::VectorXd &u);
  /// How far the present displacement and forces are from balance.
  void measure(const std::vector<FlatWall> &walls, Outcome &outcome);
  /// Places that may touch in this iteration, as columns of G.
  void find_candidates(const std::vector<FlatWall> &walls);
  /// Forces of the candidates; α is raised until there are some that belong to a minimum.
  std::string find_forces(const std::vector<FlatWall> &walls, Outcome &outcome);
  std::string iterate(const std::vector<FlatWall> &walls, Outcome &outcome);
  /// Goes to @p to, or as far that way as the points bear, forces with it.
  std::string go(const Eigen::VectorXd &direction, const Forces &to, double share);

  Body<dim> &body;
  const Settings &settings;
  const double cell_size;
  const std::vector<std::vector<dealii::Point<dim>>> places; ///< of every wall
  std::vector<std::vector<PlaceFunctions<dim>>> functions;   ///< of the field at the places
  SystemMatrix matrix;
  std::unique_ptr<LowRankSolver> solver;
  double usual_shift = 0., shift = 0.; ///< α times the mass of the body [N/m]
  Eigen::VectorXd weights;             ///< of nodes: shares of the mass of the body, not negative
  Eigen::VectorXd start;               ///< displacement when the search began
  Eigen::MatrixXd rotations;           ///< mean rotations about the axes, per displacement [rad/m]
  double against_rotation = 0.;        ///< [N m]
  Eigen::VectorXd holding;             ///< forces of the torque that keeps the body from turning [N]
  Eigen::VectorXd internal;            ///< force [N]
  StepState<dim> trial;
  Forces force; ///< of all places at all walls [N]

  struct Candidate
  {
    std::size_t wall, place;
  };
  std::vector<Candidate> candidates;
  LinearSolver::Rows gradients; ///< Gᵀ
  OneSidedForces contact;
};
} // namespace softgrain::mpm

#endif
