// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/parse_request.h>
#include <softgrain/parameters/parameter_values.h>

namespace softgrain
{
template <int dim>
void parse_request(dealii::ParameterHandler &prm, BallRequest<dim> &request)
{
  request.number = prm.get_integer("Number");
  if (request.number == 0)
    throw InputError(
        "'Packing/Number' = '0' is not allowed with 'Packing/Method' = 'random': it must be at least 1");
  if (!prm.get("File").empty())
    throw InputError("'Packing/File' = '" + prm.get("File") + "' is not allowed with 'Packing/Number' = '" +
                     prm.get("Number") + "': either make a packing or read one");
  request.sizes.parse_parameters(prm, "Packing");
  request.lower = dealii::Point<dim>(vector_of_numbers<dim>(prm.get("Lower")));
  request.upper = dealii::Point<dim>(vector_of_numbers<dim>(prm.get("Upper")));
  request.fraction = prm.get_double("Packing fraction");
  request.seed = prm.get_integer("Seed");
}

template <int dim>
void check_box(const dealii::ParameterHandler &prm,
               const BallRequest<dim> &request,
               const double least,
               const std::string &grain)
{
  for (unsigned int d = 0; d < dim; ++d)
    if (!(request.upper[d] - request.lower[d] > least))
      throw InputError("'Packing/Upper' = '" + prm.get("Upper") +
                       "' is not allowed: the box from 'Lower' = '" + prm.get("Lower") +
                       "' on must be larger than a " + grain);
}

template void parse_request(dealii::ParameterHandler &, BallRequest<2> &);
template void parse_request(dealii::ParameterHandler &, BallRequest<3> &);
template void
check_box(const dealii::ParameterHandler &, const BallRequest<2> &, double, const std::string &);
template void
check_box(const dealii::ParameterHandler &, const BallRequest<3> &, double, const std::string &);
} // namespace softgrain
