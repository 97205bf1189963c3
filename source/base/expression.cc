// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/nearest_name.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace softgrain
{
namespace
{
/// Whether '=' stands alone: muParser would give the variable a new value.
bool assigns(const std::string &text)
{
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1))
  {
    if (i > 0 && std::string("<>!").find(text[i - 1]) != std::string::npos)
      continue;
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else
      return true;
  }
  return false;
}
} // namespace

struct Expression::Parser
{
  Parser(const std::string &text, const std::vector<std::string> &variables)
      : text(text), variables(variables), values(variables.size(), 0.)
  {
    if (assigns(text))
      throw InputError("'" + text + "' is not a formula of " + join(variables, "constants") +
                       ": '=' alone compares nothing, write '=='");
    try
    {
      parser.DefineConst("pi", 3.14159265358979323846);
      // muParser keeps the addresses, so `values` must never grow after this.
      for (std::size_t i = 0; i < variables.size(); ++i)
        parser.DefineVar(variables[i], &values[i]);
      parser.SetExpr(text);
      int n_values = 0;
      parser.Eval(n_values);
      if (n_values != 1)
        throw InputError("'" + text + "' is a list of " + std::to_string(n_values) +
                         " formulas; one is allowed, without ','");
    }
    catch (const mu::Parser::exception_type &error)
    {
      std::string message = error.GetMsg();
      std::replace(message.begin(), message.end(), '\n', ' ');
      throw InputError("'" + text + "' is not a formula of " + join(variables, "constants") + ": " + message);
    }
  }

  std::string text;
  std::vector<std::string> variables;
  std::vector<double> values;
  mu::Parser parser;
};

Expression::Expression(const std::string &text, const std::vector<std::string> &variables)
    : parser(std::make_unique<Parser>(text, variables))
{
}

Expression::Expression(const Expression &other)
    : parser(std::make_unique<Parser>(other.parser->text, other.parser->variables))
{
}

Expression::Expression(Expression &&) noexcept = default;

Expression &Expression::operator=(const Expression &other)
{
  if (this != &other)
    parser = std::make_unique<Parser>(other.parser->text, other.parser->variables);
  return *this;
}

Expression &Expression::operator=(Expression &&) noexcept = default;

Expression::~Expression() = default;

double Expression::operator()(const std::vector<double> &values) const
{
  if (values.size() != parser->values.size())
    throw std::logic_error("wrong number of variables for '" + parser->text + "'");
  std::copy(values.begin(), values.end(), parser->values.begin());
  return parser->parser.Eval();
}

const std::string &Expression::text() const
{
  return parser->text;
}

std::vector<Expression> vector_expression(const std::string &text,
                                          const std::vector<std::string> &variables,
                                          const unsigned int n_components)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ';');)
  {
    const auto first = part.find_first_not_of(" \t");
    parts.push_back(first == std::string::npos ? "" : part.substr(first));
  }
  // Before any is parsed: a comma in the place of a semicolon is told here.
  if (parts.size() != n_components)
    throw InputError("'" + text + "' must be " + std::to_string(n_components) +
                     " formulas separated by ';', not " + std::to_string(parts.size()));
  std::vector<Expression> components;
  for (const std::string &part : parts)
    components.emplace_back(part, variables);
  return components;
}

Expression formula_of_time(const std::string &text, const std::string &parameter)
{
  try
  {
    Expression formula(text, {"t"});
    if (!std::isfinite(formula({0.})))
      throw InputError("'" + text + "' is not finite at the start");
    return formula;
  }
  catch (const InputError &error)
  {
    throw InputError("'" + parameter + "': " + error.what());
  }
}
} // namespace softgrain
