// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_body_terms_h
#define softgrain_mpm_stepping_body_terms_h

#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/body/whole_rotation.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/**
 * @brief What the scheme of an implicit step adds to the forces of one body in its equation: inertia
 * (BodyInertia), or what resists motion where there is none (BodyResistance). The equations of a step ask,
 * and need not know which it is.
 */
template <int dim>
class BodyTerms
{
public:
  virtual ~BodyTerms() = default;

  /// Displacement over the step for the end velocity @p v [m].
  virtual Eigen::VectorXd increment(const Body<dim> &body, const Eigen::VectorXd &v) const = 0;
  /// The end velocity for a displacement over the step [m/s].
  virtual Eigen::VectorXd end_velocity(const Body<dim> &body, const Eigen::VectorXd &way) const = 0;

  /// Loads that see the velocity change from trial to trial: tells it those of the next one.
  virtual void note_load(const Body<dim> &, const Eigen::VectorXd &) {}

  /// Impulse that is missing for the end velocity @p v, without contact [N s m^(dim-3)].
  virtual void find_missing(const Body<dim> &body,
                            const Eigen::VectorXd &v,
                            const Eigen::VectorXd &increment,
                            const Eigen::VectorXd &internal,
                            const Eigen::VectorXd &load,
                            Eigen::VectorXd &missing) = 0;

  /// Factor on the stiffness in Newton's matrix of the step [s^2].
  virtual double stiffness_weight() const = 0;
  /// Adds what goes with the velocity of nodes to a matrix that has the stiffness.
  virtual void add_mass(const Body<dim> &body, SystemMatrix &matrix) const = 0;
  /// Stiffness against a turn that goes with it, of the columns held() [N s^2 m^(dim-2)].
  virtual double held_weight(const Body<dim> &body, const StepState<dim> &trial) const = 0;
  virtual const WholeRotation<dim> &held() const = 0;
  virtual const WholeRotation<dim> &turn() const = 0; ///< at the start of the step

  /// What the scheme takes in a step to the velocity @p v, to second order in the step [J m^(dim-3)].
  virtual double damping(const Body<dim> &body,
                         const Eigen::VectorXd &v,
                         const Eigen::VectorXd &increment,
                         const Eigen::VectorXd &internal) const = 0;
  /// What regularising forces take in a step [J m^(dim-3)].
  virtual double regularisation_work(const Body<dim> &body, const Eigen::VectorXd &increment) const = 0;

  /// Amounts of momentum of the nodes at the start; against them impulses are measured [N s m^(dim-3)].
  struct Momentum
  {
    double largest = 0.; ///< of a node
    double sum = 0.;     ///< of all
  };
  /// None where bodies have no velocity.
  virtual Momentum momentum_of_nodes(const Body<dim> &) const { return {}; }

  /// What resists the motion of the body at the end of a step without inertia [N m^(dim-3)].
  virtual dealii::Tensor<1, dim> resistance(const Body<dim> &, const Eigen::VectorXd &) const { return {}; }
  /// What State::held_back will be of it [N m^(dim-3)].
  virtual double held_back(const Body<dim> &, const Eigen::VectorXd &) const { return 0.; }
  /// Makes it resist motion by @p factor more, also in the impulse that is missing for the velocities @p v
  /// and in a matrix that was filled for these, if one is given.
  virtual void resist_more(const Body<dim> & /*body*/,
                           double /*factor*/,
                           const Eigen::VectorXd & /*v*/,
                           Eigen::VectorXd & /*missing*/,
                           SystemMatrix * /*matrix*/)
  {
  }
};
} // namespace softgrain::mpm

#endif
