// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_body_resistance_h
#define softgrain_mpm_stepping_body_resistance_h

#include <softgrain/mpm/stepping/body_terms.h>
#include <softgrain/mpm/stepping/nodal_resistance.h>
#include <softgrain/mpm/stepping/step.h>
#include <softgrain/mpm/stepping/time_integrator.h>

namespace softgrain::mpm
{
/**
 * @brief What resists the motion of one body in a step without inertia: a share of the stiffness of its
 * softest material of the scene against the motion of nodes, and against a turn of the whole: a hard body
 * among soft ones is held by what they can bear. See doc/theory.md, "Without inertia".
 */
class BodyResistance final : public BodyTerms<2>
{
public:
  explicit BodyResistance(const BodyStart &start);

  Eigen::VectorXd increment(const Body<2> &body, const Eigen::VectorXd &v) const override;
  Eigen::VectorXd end_velocity(const Body<2> &, const Eigen::VectorXd &way) const override
  {
    return way / dt;
  }
  void find_missing(const Body<2> &body,
                    const Eigen::VectorXd &v,
                    const Eigen::VectorXd &increment,
                    const Eigen::VectorXd &internal,
                    const Eigen::VectorXd &load,
                    Eigen::VectorXd &missing) override;
  double stiffness_weight() const override { return dt * dt; }
  void add_mass(const Body<2> &body, SystemMatrix &matrix) const override;
  double held_weight(const Body<2> &, const StepState<2> &) const override { return weight; }
  const WholeRotation<2> &held() const override { return rotation; }
  const WholeRotation<2> &turn() const override { return rotation; }
  double damping(const Body<2> &,
                 const Eigen::VectorXd &,
                 const Eigen::VectorXd &,
                 const Eigen::VectorXd &) const override
  {
    return 0.;
  }
  double regularisation_work(const Body<2> &body, const Eigen::VectorXd &increment) const override;
  dealii::Tensor<1, 2> resistance(const Body<2> &body, const Eigen::VectorXd &increment) const override;
  double held_back(const Body<2> &body, const Eigen::VectorXd &increment) const override;
  void resist_more(const Body<2> &body,
                   double factor,
                   const Eigen::VectorXd &v,
                   Eigen::VectorXd &missing,
                   SystemMatrix *matrix) override;

private:
  double dt;
  NodalResistance<2> nodes; ///< [N s^2/m/m]
  double weight;            ///< of the torque, per radian [N s^2 m/m]
  WholeRotation<2> rotation;
  dealii::Tensor<1, 2> before;
};
} // namespace softgrain::mpm

#endif
