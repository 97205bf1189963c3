// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_expression_h
#define softgrain_base_expression_h

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief One or more formulas of named variables, "vx; vy", evaluated by muParser.
 *
 * `pi` is known besides muParser's own functions. Evaluation changes the object: use one per thread.
 */
class Expression
{
public:
  /**
   * @param text         formulas separated by semicolons
   * @param variables    their names, in the order in which operator() takes the values
   * @param n_components number of formulas wanted
   * @throw InputError with muParser's message when the text cannot be understood
   */
  Expression(const std::string &text, const std::vector<std::string> &variables, unsigned int n_components = 1);
  ~Expression();
  Expression(Expression &&) noexcept;
  Expression &operator=(Expression &&) noexcept;

  /// Value of formula @p component; @throw ComputationError when it is not a finite number.
  double operator()(const std::vector<double> &values, unsigned int component = 0) const;

private:
  struct Parsers;
  std::unique_ptr<Parsers> parsers;
};
} // namespace softgrain

#endif
