// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_even_exponent_h
#define softgrain_base_even_exponent_h

#include <cmath>

namespace softgrain
{
/**
 * A power of two, 1 or 2, that makes the exponent of @p x even.
 *
 * Rounding does not commute with roots: sqrt(2x) is not sqrt(x) times a number of the machine, while sqrt(4x)
 * is 2 sqrt(x). A matrix that is multiplied by this factor of one of its entries before it is factorised by
 * roots gives the same bits in all units that are powers of two of each other.
 */
inline double for_even_exponent(const double x)
{
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent % 2 == 0 ? 1. : 2.;
}
} // namespace softgrain

#endif
