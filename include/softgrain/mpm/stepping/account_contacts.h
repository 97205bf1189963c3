// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_account_contacts_h
#define softgrain_mpm_stepping_account_contacts_h

#include <softgrain/mpm/contact/contact_kinks.h>
#include <softgrain/mpm/stepping/step.h>

#include <vector>

namespace softgrain::mpm
{
/// The part of accept_step() that books what walls and obstacles feel and the work done at the contacts
/// during a step of @p dt [s].
/// @param rate mean velocity of the nodes, with which impulses do their work [m/s]
/// @param kinks what the mean of both ends lacks, without inertia
void account_contacts(const Problem &problem,
                      State &state,
                      const Workspace &work,
                      double dt,
                      const std::vector<Eigen::VectorXd> &rate,
                      const std::vector<WallMotion<2>> &motion,
                      const ContactKinks &kinks);
} // namespace softgrain::mpm

#endif
