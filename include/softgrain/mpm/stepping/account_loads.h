// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_account_loads_h
#define softgrain_mpm_stepping_account_loads_h

#include <softgrain/mpm/stepping/accept_step.h>

#include <vector>

namespace softgrain::mpm
{
/// Powers of all loads on a body but the last one, which has what is left of the whole [W/m^(3-dim)].
/// @param increment of the step @param rate of the nodes; with a way in its place they are works
template <int dim>
std::vector<double> powers_of_loads(const Body<dim> &body,
                                    const LoadTimes &times,
                                    const Eigen::VectorXd &increment,
                                    const Eigen::VectorXd &rate);

/// Books the work of every load in a step that has been found, and its impulse on the bodies, before these
/// move: for all alike.
void account_loads(State &state, Workspace &work, const FoundStep &step);
} // namespace softgrain::mpm

#endif
