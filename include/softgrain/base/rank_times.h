// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_rank_times_h
#define softgrain_base_rank_times_h

#include <cstdint>

namespace softgrain
{
/// What working with others took so far of one process.
struct RankTimes
{
  double own = 0;             ///< in work that it alone does, of all its threads [processor s]
  double waiting = 0;         ///< for others, what they send included [s]
  double spinning = 0;        ///< the same [processor s]: MPI looks for messages all the time
  std::uint64_t messages = 0; ///< times that all met
  std::uint64_t bytes = 0;    ///< that came from others
};

/// Processor time of all threads of this process so far [s].
double processor_seconds();
} // namespace softgrain

#endif
