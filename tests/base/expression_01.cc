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
  for (const char *text : {"", "t +", "z", "sin(t", "2; 3; 4", "2;", "; 1"})
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
