// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_contact_profile_h
#define softgrain_analysis_contact_profile_h

#include <softgrain/analysis/snapshot.h>

#include <array>
#include <vector>

namespace softgrain
{
/// A short piece of a contact.
struct ContactPiece
{
  dealii::Point<2> place;         ///< its middle [m]
  dealii::Tensor<1, 2> direction; ///< unit, with the first body to the left
  double length = 0.;             ///< [m]
  double pressure = 0.;           ///< [Pa], negative where it pulls
  double traction = 0.;           ///< [Pa], positive where it pulls the first body on along the contact
};

/**
 * @brief Pressure and traction along one contact, from one of its ends to the other.
 *
 * Forces at single places tell no pressure: their neighbours share them in any way. What they tell is their
 * resultant, where it acts and how far they spread. Between outlines without corners the pressure is
 * therefore the half ellipse of the same resultant, line of action and second moment, with further terms in
 * wide contacts; narrow ones have the width of Hertz's law, where it is known. Sums of pressure times length
 * are forces exactly. doc/results/contact-geometry.md has what this is worth; the Python package does the
 * same.
 * @param places the contacts of one body with one partner
 */
std::vector<ContactPiece> contact_profile(const Snapshot<2> &snapshot,
                                          const std::vector<ContactState<2>> &places);
} // namespace softgrain

#endif
