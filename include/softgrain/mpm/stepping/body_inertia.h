// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_body_inertia_h
#define softgrain_mpm_stepping_body_inertia_h

#include <softgrain/mpm/stepping/body_terms.h>
#include <softgrain/mpm/stepping/time_scheme.h>

#include <Eigen/Core>

namespace softgrain::mpm
{
/**
 * @brief What inertia is to one body in an implicit step, in the plane and in space: the impulse that is
 * missing, its part of Newton's matrix, and what keeps the spin of a body that nothing has a lever on. See
 * doc/theory.md, "Rotation under pressure".
 */
template <int dim>
class BodyInertia final : public BodyTerms<dim>
{
public:
  /// @param keeps_spin a round body without friction: its spin is held in steps that are longer than a wave
  /// takes from its middle to its rim. Such steps resolve no hit, and as the cut cells of a rim press askew,
  /// grains that are squeezed slowly would turn on and on.
  /// @param load on the body, empty where there is none [N m^(dim-3)]
  void begin(const Body<dim> &body,
             const TimeScheme &scheme,
             double dt,
             bool keeps_spin,
             const Eigen::VectorXd &load);

  /// Loads that see the velocity change it from trial to trial: begin() knows those of the start alone.
  void note_load(const Body<dim> &body, const Eigen::VectorXd &load) override;

  Eigen::VectorXd increment(const Body<dim> &body, const Eigen::VectorXd &v) const override;
  Eigen::VectorXd end_velocity(const Body<dim> &body, const Eigen::VectorXd &way) const override;
  void find_missing(const Body<dim> &body,
                    const Eigen::VectorXd &v,
                    const Eigen::VectorXd &increment,
                    const Eigen::VectorXd &internal,
                    const Eigen::VectorXd &load,
                    Eigen::VectorXd &missing) override;

  double stiffness_weight() const override { return theta * theta * dt * dt; }
  void add_mass(const Body<dim> &body, SystemMatrix &matrix) const override
  {
    matrix.add_mass<dim>(body.nodes.mass, 1.);
  }
  double held_weight(const Body<dim> &body, const StepState<dim> &trial) const override;
  const WholeRotation<dim> &held() const override { return keeps ? lever : rotation; }
  const WholeRotation<dim> &turn() const override { return rotation; }

  double damping(const Body<dim> &body,
                 const Eigen::VectorXd &v,
                 const Eigen::VectorXd &increment,
                 const Eigen::VectorXd &internal) const override;
  double regularisation_work(const Body<dim> &, const Eigen::VectorXd &increment) const override
  {
    return held_work(increment);
  }
  typename BodyTerms<dim>::Momentum momentum_of_nodes(const Body<dim> &body) const override;
  /// What the torque takes that keeps the spin [J m^(dim-3)].
  double held_work(const Eigen::VectorXd &increment) const
  {
    return keeps ? holding.dot(rotation.transpose() * increment) / dt : 0.;
  }

private:
  Eigen::VectorXd acting_force(const Body<dim> &body, const Eigen::VectorXd &internal) const;

  double theta = 1., dt = 0., weight = 0.;
  bool keeps = false;
  WholeRotation<dim> rotation;
  WholeRotation<dim> lever; ///< of the torque that keeps the spin, where the body is halfway
  Turn<dim> half_turn;      ///< over half the step, by which its forces are turned
  Turn<dim> spin;           ///< its change by loads [1/s]
  Turn<dim> holding;        ///< torque that keeps it, times the step
};
} // namespace softgrain::mpm

#endif
