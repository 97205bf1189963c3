// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_driven_work_h
#define softgrain_mpm_stepping_driven_work_h

#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/contact/contact_kinks.h>

#include <vector>

namespace softgrain::mpm
{
/// Work of something driven, and by how much it differs from that of the force at either end [J/m^(3-dim)].
struct DrivenWork
{
  double *work;
  double most;
};

/// Books what an obstacle does in a step from balance to balance: the work of the mean of both ends.
/// @param force,torque that it felt at the start
template <int dim>
void book_obstacle(Obstacle<dim> &obstacle,
                   const dealii::Tensor<1, dim> &force,
                   double torque,
                   std::vector<DrivenWork> &driven);

/// Gives to all that is driven what the mean of both ends lacks, in proportion to the change of its force:
/// its work lies between those of the forces at both ends. @return the share that could be given
double give_kinks(const ContactKinks &kinks, const std::vector<DrivenWork> &driven);
} // namespace softgrain::mpm

#endif
