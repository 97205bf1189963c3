// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_parse_request_h
#define softgrain_packing_parse_request_h

#include <softgrain/packing/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace softgrain
{
/// Reads what packings at random have in common in the plane and in space from the section 'Packing'.
/// @throw InputError when there is no number, or a file to be read beside it
template <int dim>
void parse_request(dealii::ParameterHandler &prm, BallRequest<dim> &request);

/// @throw InputError unless all edges of the box are longer than @p least [m]
/// @param grain what must fit in, for the message
template <int dim>
void check_box(const dealii::ParameterHandler &prm,
               const BallRequest<dim> &request,
               double least,
               const std::string &grain);
} // namespace softgrain

#endif
