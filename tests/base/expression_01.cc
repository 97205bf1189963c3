// SPDX-License-Identifier: LGPL-2.1-or-later
// Values of formulas, independence of copies, and what is said of formulas that are none.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>

#include <iostream>

int main()
{
  using namespace softgrain;
  const Expression ramp("t < 1 ? 0.2*sin(pi*t/2) : 0.2", {"t"});
  const Expression copy = ramp;
  std::cout << ramp({0.5}) << ' ' << copy({2.}) << ' ' << ramp({0.}) << '\n';
  const auto velocity = vector_expression("-y; x + 2", {"x", "y"});
  std::cout << velocity[0]({3., 4.}) << ' ' << velocity[1]({3., 4.}) << '\n';
  // What doc/formulas.md lists.
  for (const char *text : {"2^3^2",           "-2^2",         "7 - 4/2*3",    "1 < 2 && 2 <= 2 || 0",
                           "3 > 2 ? 10 : 20", "1 != 2",       "2 == 2",       "2 >= 3",
                           "log(_e^2)",       "ln(_e)",       "log2(8)",      "log10(100)",
                           "exp(0)",          "sqrt(9)",      "abs(-3)",      "sign(-3)",
                           "rint(2.6)",       "min(3, 1, 2)", "max(3, 1, 2)", "sum(3, 1, 2)",
                           "avg(3, 1, 2)",    "sin(pi/2)",    "cos(pi)",      "tan(pi/4)",
                           "asin(1)",         "acos(1)",      "atan(1)",      "atan2(1, 1)",
                           "sinh(0)",         "cosh(0)",      "tanh(0)",      "asinh(0)",
                           "acosh(1)",        "atanh(0)"})
    std::cout << text << " -> " << Expression(text, {})({}) << '\n';
  for (const char *text : {"0.04, 0", "t = 2", "t == 2", "t <= 2"})
    try
    {
      std::cout << Expression(text, {"t"})({2.}) << '\n';
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
  for (const char *text : {"", "t +; 1", "z; 1", "sin(t; 1", "2; 3; 4", "2;", "; 1", "0.04, 0", "1; 2, 3"})
    try
    {
      vector_expression(text, {"t"});
      std::cout << "'" << text << "' passed\n";
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
