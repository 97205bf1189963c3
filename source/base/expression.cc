// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/nearest_name.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
struct Expression::Parsers
{
  std::string text;
  std::vector<double> variables;
  std::vector<mu::Parser> formulas;
};

Expression::Expression(const std::string &text,
                       const std::vector<std::string> &variables,
                       const unsigned int n_components)
    : parsers(std::make_unique<Parsers>())
{
  parsers->text = text;
  parsers->variables.assign(variables.size(), 0.);
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == ';')
      parts.emplace_back();
    else
      parts.back() += c;
  if (parts.size() != n_components)
    throw InputError("'" + text + "' has " + std::to_string(parts.size()) +
                     " formulas separated by ';', but " + std::to_string(n_components) + " are needed");
  for (const std::string &part : parts)
    try
    {
      mu::Parser parser;
      for (std::size_t v = 0; v < variables.size(); ++v)
        parser.DefineVar(variables[v], &parsers->variables[v]);
      parser.DefineConst("pi", M_PI);
      parser.SetExpr(part);
      parser.Eval();
      parsers->formulas.push_back(parser);
    }
    catch (const mu::Parser::exception_type &error)
    {
      std::string message = error.GetMsg();
      std::replace(message.begin(), message.end(), '\n', ' ');
      throw InputError("'" + part + "' is not a formula of " + join(variables, "numbers") + ": " + message);
    }
}

Expression::~Expression() = default;
Expression::Expression(Expression &&) noexcept = default;
Expression &Expression::operator=(Expression &&) noexcept = default;

double Expression::operator()(const std::vector<double> &values, const unsigned int component) const
{
  std::copy(values.begin(), values.end(), parsers->variables.begin());
  const double value = parsers->formulas[component].Eval();
  if (!std::isfinite(value))
    throw ComputationError("the formula '" + parsers->text + "' gives a value that is not finite");
  return value;
}
} // namespace softgrain
