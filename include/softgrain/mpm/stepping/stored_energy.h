// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_stored_energy_h
#define softgrain_mpm_stepping_stored_energy_h

#include <Eigen/Core>

#include <vector>

namespace softgrain::mpm
{
class BodyShare;
struct State;

/// Elastic energy of the bodies that no drive moves, after an increment of their nodes [J/m].
/// @param increment displacement of the nodes of each body; null: none
double elastic_energy(const State &state,
                      const BodyShare &share,
                      const std::vector<Eigen::VectorXd> *increment = nullptr);

/// Elastic energy of the bodies and of the dents that the grid misses [J/m].
double stored_energy(const State &state, const BodyShare &share);
} // namespace softgrain::mpm

#endif
