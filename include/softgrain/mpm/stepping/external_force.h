// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_external_force_h
#define softgrain_mpm_stepping_external_force_h

#include <softgrain/mpm/body/body_share.h>

#include <Eigen/Core>

#include <vector>

namespace softgrain
{
class SystemMatrix;
}

namespace softgrain::mpm
{
/// When loads are taken.
struct LoadTimes
{
  double at = 0;    ///< of loads that see no velocity [s]
  double begin = 0; ///< of the step [s]
  double dt = 0;    ///< its length [s]
  bool from_the_start =
      false; ///< loads that see the velocity know that of the start, see mean_acceleration()
};

/// Adds the force of one load to those on the independent nodes [N]. @param increment of the step, which
/// says where nodes are and how fast; null where that is not asked for
template <int dim>
void add_force(const Load<dim> &load,
               const Body<dim> &body,
               const LoadTimes &times,
               const Eigen::VectorXd *increment,
               Eigen::VectorXd &force);

/// Force on the independent nodes of all loads that do not depend on where a trial ends [N]; false when there
/// is none.
template <int dim>
bool external_force(const Body<dim> &body, const LoadTimes &times, Eigen::VectorXd &force);

/// Adds the force of the others, for a trial of an implicit step.
template <int dim>
void add_forces_of_velocity(const Body<dim> &body,
                            const LoadTimes &times,
                            const Eigen::VectorXd &increment,
                            Eigen::VectorXd &force);

/// Takes the tangent of these forces from Newton's matrix. What is not symmetric of it, as that of Coriolis
/// forces, is left to the iterations: the matrix has to be, and the error of one is some 2 theta dt times the
/// angular velocity smaller than that of the one before. @param factor theta dt
template <int dim>
void add_load_tangent(const Body<dim> &body,
                      const LoadTimes &times,
                      const Eigen::VectorXd &increment,
                      double factor,
                      SystemMatrix &matrix);

/// External forces on all bodies that are not driven, known to all; empty vectors where there is none. Loads
/// that are the same everywhere are computed by all alike, others by the owner of a body.
std::vector<Eigen::VectorXd>
external_forces(const std::vector<Body<2>> &bodies, const BodyShare &share, const LoadTimes &times);
} // namespace softgrain::mpm

#endif
