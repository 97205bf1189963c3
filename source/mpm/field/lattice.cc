// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/field/lattice.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain::mpm
{
template <int dim>
Lattice<dim>::Lattice(const dealii::Point<dim> &lower,
                      const dealii::Point<dim> &upper,
                      const double cell_size)
    : origin(lower), h(cell_size)
{
  for (unsigned int d = 0; d < dim; ++d)
    // A mesh that ends within rounding of `upper` must not grow by one row of cells.
    cells[d] = std::max(1, static_cast<int>(std::ceil((upper[d] - lower[d]) / h - rounding)));
}

template <int dim>
void Lattice<dim>::check_inside(const dealii::Point<dim> &x, const std::string &thing) const
{
  if (contains(cell_of(x)))
    return;
  std::ostringstream message;
  message << "a " << thing << " at (" << x
          << ") m lies outside of the background mesh: enlarge 'Mesh/Lower' and 'Mesh/Upper'";
  throw ComputationError(message.str());
}

template class Lattice<2>;
template class Lattice<3>;
} // namespace softgrain::mpm
