// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_image_lattice_h
#define softgrain_contact_image_lattice_h

#include <array>

namespace softgrain::contact
{
/**
 * @brief How disks repeat, as a neighbour list sees it: along x, y or both, the cells above at an offset.
 *
 * The image n of a place x is x + shift(n). See PeriodicCell, which says the same to the rest of the program.
 */
struct ImageLattice
{
  using Image = std::array<int, 2>;

  std::array<bool, 2> periodic{};
  std::array<double, 2> lower{};        ///< corner of the cell [m]
  std::array<double, 2> length{{1, 1}}; ///< [m]
  double offset = 0;                    ///< along x of the cell above [m]

  bool repeats() const { return periodic[0] || periodic[1]; }

  std::array<double, 2> shift(const Image &n) const
  {
    return {{n[0] * length[0] + n[1] * offset, n[1] * length[1]}};
  }
};
} // namespace softgrain::contact

#endif
