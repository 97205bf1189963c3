// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_place_slide_h
#define softgrain_mpm_contact_place_slide_h

#include <softgrain/mpm/field/body_field.h>

#include <deal.II/base/tensor.h>

namespace softgrain::mpm
{
/**
 * @brief How far the places at which a round body looks for contact with one partner slide along its outline
 * as the two move: a linear form in the displacements of their nodes, in markers.
 *
 * Such places stand on rays from the centre of mass of the body, counted from the one towards the centre of
 * its partner. They slide when that line turns, and when the outline moves across the ray. A gap that has a
 * slope along the outline changes by that, too: without it contact forces are not those of a potential, and
 * turn bodies that nothing can turn.
 *
 * The form is `of_body_centre` times the displacement of the centre of mass of the body, less `across` times
 * that of the outline at `place`, plus `of_centre` times that of the centre of the partner.
 */
template <int dim>
struct PlaceSlide
{
  NodeWeights place;                     ///< where the ray to the partner leaves the body
  dealii::Tensor<1, dim> across;         ///< [1/m]
  dealii::Tensor<1, dim> of_body_centre; ///< [1/m]
  /// What the partner as a whole adds when it moves, and the body takes off; 0 for a wall [1/m].
  dealii::Tensor<1, dim> of_centre;
  double way = 0; ///< over the step, as far as that is known; without what a cell that repeats does [markers]
};
} // namespace softgrain::mpm

#endif
