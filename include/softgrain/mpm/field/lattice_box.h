// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_lattice_box_h
#define softgrain_mpm_field_lattice_box_h

#include <array>

namespace softgrain::mpm
{
/// Integer power of a small number.
constexpr unsigned int power(const unsigned int base, const int exponent)
{
  unsigned int result = 1;
  for (int d = 0; d < exponent; ++d)
    result *= base;
  return result;
}

/// Calls f(index) for all integer points of the box [lower, upper], first coordinate fastest.
template <int dim, typename F>
void for_box(const std::array<int, dim> &lower, const std::array<int, dim> &upper, const F &f)
{
  std::array<int, dim> i = lower;
  while (true)
  {
    f(i);
    int d = 0;
    while (d < dim && ++i[d] > upper[d])
    {
      i[d] = lower[d];
      ++d;
    }
    if (d == dim)
      return;
  }
}
} // namespace softgrain::mpm

#endif
