// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_driven_work_h
#define softgrain_mpm_stepping_driven_work_h

#include <softgrain/driving/rigid_partner.h>
#include <softgrain/mpm/contact/contact_kinks.h>

#include <vector>

namespace softgrain::mpm
{
/// Gives to all that is driven what the mean of both ends lacks, in proportion to the change of its force:
/// its work lies between those of the forces at both ends. @return the share that could be given
double give_kinks(const ContactKinks &kinks, const std::vector<DrivenWork> &driven);
} // namespace softgrain::mpm

#endif
