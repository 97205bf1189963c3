// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/utilities.h>

namespace softgrain
{
dealii::Tensor<1, 2> pair_of_numbers(const std::string &text)
{
  const std::vector<double> numbers =
      dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(text, ","));
  dealii::Tensor<1, 2> pair;
  for (unsigned int d = 0; d < 2; ++d)
    pair[d] = numbers.at(d);
  return pair;
}

std::vector<dealii::Tensor<1, 2>> list_of_pairs(const std::string &text)
{
  std::vector<dealii::Tensor<1, 2>> pairs;
  for (const std::string &part : dealii::Utilities::split_string_list(text, ";"))
    pairs.push_back(pair_of_numbers(part));
  return pairs;
}
} // namespace softgrain
