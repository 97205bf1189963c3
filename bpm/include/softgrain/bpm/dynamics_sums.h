// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_dynamics_sums_h
#define softgrain_bpm_dynamics_sums_h

#include <deal.II/base/tensor.h>

#include <cstddef>

namespace softgrain::bpm
{
/// Sums over all primaries and contacts, whoever owns them.
struct DynamicsSums
{
  double kinetic = 0.;           ///< energy [J/m]
  double moving = 0.;            ///< mass times speed of all primaries [kg/s]
  dealii::Tensor<1, 2> momentum; ///< of the primaries that are not fixed [kg/s]
  double attraction = 0.;        ///< energy of the attractions, zero when all pairs are out of range [J/m]
  std::size_t n_pairs = 0, n_contacts = 0;
  std::size_t n_pushing = 0; ///< contacts that carry force
};
} // namespace softgrain::bpm

#endif
