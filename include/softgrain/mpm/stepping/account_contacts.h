// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_account_contacts_h
#define softgrain_mpm_stepping_account_contacts_h

#include <softgrain/mpm/stepping/accept_step.h>

namespace softgrain::mpm
{
/// The part of accept_step() that books what walls and obstacles feel and the work done at the contacts
/// during a step.
void account_contacts(const Problem &problem, State &state, const Workspace &work, const FoundStep &step);
} // namespace softgrain::mpm

#endif
