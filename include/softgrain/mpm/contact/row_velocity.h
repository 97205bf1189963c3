// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_row_velocity_h
#define softgrain_mpm_contact_row_velocity_h

#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/model/workspace.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief How closed gaps open again.
 *
 * A stretch of outline that is found in something all at once is to be pushed out without getting a velocity.
 * Opened in one short step its velocity would be its depth over the step. So of a closed gap a step opens the
 * share (c dt / length)^2, and all in steps in which a wave crosses the length: the velocity falls with the
 * step, and so does the energy that the body gets.
 */
struct Opening
{
  bool opens = false; ///< else a gap that is closed stays as it is
  double length = 0;  ///< 0: always at once [m]

  /// Share of a closed gap of @p body that opens in a step of @p dt [s]; c = sqrt(E/rho).
  template <int dim>
  double share(const Body<dim> &body, double dt) const;
};

/// H v of the rows of a step for these nodal velocities, one vector per body [m/s].
std::vector<double>
relative_velocity(const State &state, const Workspace &work, const std::vector<Eigen::VectorXd> &nodal);

/// Way over @p dt, along a component of a row, of what its body meets, where no nodes and no driven body tell
/// it: of a plane, along its normal, or of an obstacle [m].
double way_of_partner(const ContactRow<2> &row,
                      const std::vector<WallMotion<2>> &motion,
                      unsigned int component,
                      double dt);

/// How fast the sides of a row part along a component, with the velocity of walls and obstacles with which
/// they do work. @param relative of the nodes, see relative_velocity() [m/s]
double parting_at_work(const ContactRow<2> &row,
                       const std::vector<WallMotion<2>> &motion,
                       unsigned int component,
                       double relative);

/**
 * @brief Relative velocity of every row with gap terms and the motion of walls, for end velocities @p v
 * [m/s].
 *
 * The displacement of a step has a known part, from the velocities at its start, and an unknown one. As long
 * as a gap is open after the known part, the contact condition is posed for the gap at the end of the step,
 * so that nothing touches early. When the known part closes the gap, the condition is posed for the velocity.
 * @param start_relative H v at the start of the step; empty when theta is 1 [m/s]
 * @param with_impulses whether @p v holds the effect of the present impulses; the speeds of free walls then
 * do too
 * @param opening what becomes of closed gaps
 */
std::vector<double> row_velocity(const State &state,
                                 const Workspace &work,
                                 const std::vector<Eigen::VectorXd> &v,
                                 const std::vector<WallMotion<2>> &motion,
                                 const std::vector<double> &start_relative,
                                 double theta,
                                 double dt,
                                 const Opening &opening,
                                 bool with_impulses = false);
} // namespace softgrain::mpm

#endif
