// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_memory_h
#define softgrain_mpm_contact_contact_memory_h

#include <array>
#include <cstdint>
#include <unordered_map>

namespace softgrain::mpm
{
/// What the contacts of the last step gave: the next one begins with that.
template <int dim>
struct ContactMemory
{
  using Impulses = std::unordered_map<std::uint64_t, std::array<double, dim>>;

  Impulses impulses; ///< of rows that carry force, by their keys [N s/m]
  double step = 0;   ///< length of that step; 0: there was none [s]
};
} // namespace softgrain::mpm

#endif
