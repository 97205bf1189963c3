// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_ways_of_bodies_h
#define softgrain_mpm_stepping_ways_of_bodies_h

#include <softgrain/mpm/model/problem.h>
#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/model/workspace.h>

#include <deal.II/base/point.h>

#include <vector>

namespace softgrain::mpm
{
/// How far held steps take bodies: one that goes through all of the mesh will find no balance.
class WaysOfBodies
{
public:
  /// Begins with where the bodies are.
  WaysOfBodies(const Problem &problem, const State &state);

  /// @param n_steps held steps so far
  /// @throw ComputationError that names a body that nothing holds, and what would hold it
  void check(const State &state, const Workspace &work, unsigned int n_steps) const;

private:
  const Problem &problem;
  std::vector<dealii::Point<2>> start; ///< centres of mass [m]
};

/// Loads of all bodies now [N/m].
std::vector<dealii::Tensor<1, 2>> loads_of(const Problem &problem, const State &state, const Workspace &work);
} // namespace softgrain::mpm

#endif
