// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_contact_memories_h
#define softgrain_bpm_contact_memories_h

#include <softgrain/contact/pair_memory.h>
#include <softgrain/driving/adhesion.h>

#include <cstdint>
#include <vector>

namespace softgrain::bpm
{
/// Impulses remembered of a contact with a wall; the pieces of obstacles count on after the walls.
struct WallMemory
{
  std::uint32_t wall = 0, primary = 0;
  contact::PairMemory::Impulses impulse{};
};

/// What contacts remember beside the impulses of pairs, which are with these.
struct ContactMemories
{
  Adhesion adhesion; ///< of the contacts between bodies and with walls
  std::vector<WallMemory> at_walls;
};
} // namespace softgrain::bpm

#endif
