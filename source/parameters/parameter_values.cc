// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/utilities.h>

namespace softgrain
{
template <int dim>
dealii::Tensor<1, dim> vector_of_numbers(const std::string &text)
{
  const std::vector<double> numbers =
      dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(text, ","));
  dealii::Tensor<1, dim> vector;
  for (unsigned int d = 0; d < dim; ++d)
    vector[d] = numbers.at(d);
  return vector;
}

dealii::Tensor<1, 2> pair_of_numbers(const std::string &text)
{
  return vector_of_numbers<2>(text);
}

template <int dim>
std::vector<dealii::Tensor<1, dim>> list_of_vectors(const std::string &text)
{
  std::vector<dealii::Tensor<1, dim>> list;
  for (const std::string &part : dealii::Utilities::split_string_list(text, ";"))
    list.push_back(vector_of_numbers<dim>(part));
  return list;
}

template dealii::Tensor<1, 2> vector_of_numbers<2>(const std::string &);
template dealii::Tensor<1, 3> vector_of_numbers<3>(const std::string &);
template std::vector<dealii::Tensor<1, 2>> list_of_vectors<2>(const std::string &);
template std::vector<dealii::Tensor<1, 3>> list_of_vectors<3>(const std::string &);
} // namespace softgrain
