// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_place_slide_h
#define softgrain_mpm_contact_place_slide_h

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

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
 */
template <int dim>
struct PlaceSlide
{
  Eigen::VectorXd of_body,
      of_partner; ///< on the degrees of freedom of both; the second empty for a wall [1/m]
  /// What the partner as a whole adds when it moves, and the body takes off; 0 for a wall [1/m].
  dealii::Tensor<1, dim> of_centre;
};
} // namespace softgrain::mpm

#endif
