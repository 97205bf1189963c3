// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_kinks_h
#define softgrain_mpm_contact_contact_kinks_h

namespace softgrain::mpm
{
/**
 * @brief Where forces do not change evenly in a step from balance to balance.
 *
 * The work of walls is that of the mean of their forces at both ends of the step. In it is the same of all
 * contacts: a ray that closes or opens has pushed half its force over all of the gap, and one that slides
 * back has rubbed with the mean of both directions. In truth an open ray pushes nothing, and one that slides
 * rubs with its bound. By the principle of virtual work the difference is what the work of walls lacks.
 */
struct ContactKinks
{
  double of_gaps = 0.;   ///< [J/m]
  double of_slides = 0.; ///< what friction takes more than the mean of both ends does [J/m]

  double all() const { return of_gaps + of_slides; }
};
} // namespace softgrain::mpm

#endif
