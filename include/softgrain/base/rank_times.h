// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_rank_times_h
#define softgrain_base_rank_times_h

#include <cstdint>

namespace softgrain
{
/// What the exchange between ranks took so far on this one.
struct RankTimes
{
  double busy = 0;            ///< in the work of this rank alone [s]
  double waiting = 0;         ///< for others, what they send included [s]
  std::uint64_t messages = 0; ///< times that all ranks met
  std::uint64_t bytes = 0;    ///< that came from others
};
} // namespace softgrain

#endif
