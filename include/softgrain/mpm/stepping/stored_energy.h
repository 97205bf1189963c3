// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_stored_energy_h
#define softgrain_mpm_stepping_stored_energy_h

namespace softgrain::mpm
{
class BodyShare;
struct State;

/// Elastic energy of the bodies and of the dents that the grid misses [J/m].
double stored_energy(const State &state, const BodyShare &share);
} // namespace softgrain::mpm

#endif
