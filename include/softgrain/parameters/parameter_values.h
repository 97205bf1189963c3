// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_parameter_values_h
#define softgrain_parameters_parameter_values_h

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace softgrain
{
/// "a, b" or "a, b, c" as numbers; the pattern of the parameter has checked the form.
template <int dim>
dealii::Tensor<1, dim> vector_of_numbers(const std::string &text);

/// "a, b" as numbers; the pattern of the parameter has checked the form.
dealii::Tensor<1, 2> pair_of_numbers(const std::string &text);

/// "a, b; c, d; …" or "a, b, c; d, e, f; …" as numbers; the pattern of the parameter has checked the form.
template <int dim>
std::vector<dealii::Tensor<1, dim>> list_of_vectors(const std::string &text);
} // namespace softgrain

#endif
