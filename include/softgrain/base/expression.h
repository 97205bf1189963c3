// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_expression_h
#define softgrain_base_expression_h

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief A formula the user wrote, in muParser's language (+ - * / ^ ?: sin cos exp sqrt abs min max … and
 * pi).
 *
 * One object must not be evaluated by two threads at once; copies are independent and may.
 */
class Expression
{
public:
  /// @throw InputError with muParser's message when @p text is not a formula of @p variables.
  Expression(const std::string &text, const std::vector<std::string> &variables);
  Expression(const Expression &);
  Expression(Expression &&) noexcept;
  Expression &operator=(const Expression &);
  Expression &operator=(Expression &&) noexcept;
  ~Expression();

  /// The value with the variables in the order of the constructor; may be infinite or NaN.
  double operator()(const std::vector<double> &values) const;

  const std::string &text() const;

private:
  struct Parser;
  std::unique_ptr<Parser> parser;
};

/// The components of a vector formula, "fx; fy".
/// @throw InputError when there are not @p n_components of them or one is not a formula.
std::vector<Expression> vector_expression(const std::string &text,
                                          const std::vector<std::string> &variables,
                                          unsigned int n_components = 2);

/// A formula of the time t [s], finite at t = 0. @param parameter that it stands in, "Walls/top/Velocity".
/// @throw InputError naming the parameter when it is not a formula or not finite
Expression formula_of_time(const std::string &text, const std::string &parameter);
} // namespace softgrain

#endif
