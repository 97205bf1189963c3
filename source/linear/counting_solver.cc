// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/counting_solver.h>

namespace softgrain
{
bool CountingSolver::factorize(SystemMatrix &matrix)
{
  const bool new_pattern = matrix.pattern_is_new(); // the other solver takes note of it
  if (!inner->factorize(matrix))
    return false;
  negative = inner->n_negative();
  if (negative)
    return true;
  if (counter == nullptr || new_pattern)
    counter = std::make_unique<CholeskySolver>();
  if (!counter->factorize(matrix))
    return false;
  negative = counter->n_negative();
  return true;
}
} // namespace softgrain
